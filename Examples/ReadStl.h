// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadStl_h
#define ReadStl_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

/// The triangles of an .stl file, ASCII or binary. Corners with the same coordinates are one point; the
/// points are in the order in which they appear. Coordinates are floats of a binary file, doubles of text.
///
/// VTK 9.1's reader keeps floats only, and reads what is left of a cut file.
/// @throw InputError  names the line that is wrong, or says that size and number of triangles disagree
vtkSmartPointer<vtkPolyData> readStl(const std::string& file);

#endif
