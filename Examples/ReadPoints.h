// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadPoints_h
#define ReadPoints_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

/// The points of a .ply .stl .obj .vtp .vtu .off or .xyz file, without cells.
///
/// @throw InputError  the file can't be read; says why
vtkSmartPointer<vtkPolyData> readPoints(const std::string& file);

#endif
