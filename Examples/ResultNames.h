// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResultNames_h
#define ResultNames_h

#include <vtkType.h>

#include <filesystem>
#include <set>
#include <string>

/// The name of the mesh of a part, as part-12.stl.
std::string partFileName(vtkIdType part);

/// The names of all files that the program may write into a folder, and of the meshes of parts that are in it. New
/// results take the place of all files of these names: a picture of an older result does not stay beside
/// them.
std::set<std::string> resultNames(const std::filesystem::path& folder);

#endif
