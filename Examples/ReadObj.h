// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadObj_h
#define ReadObj_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

/// The points (v) and polygons (f) of a Wavefront .obj file, a point for each v, as doubles. Texture
/// coordinates and normals are left out; curves, surfaces and materials too.
///
/// VTK 9.1's reader keeps floats only, reads words as zeros, and crashes where a face names what does not
/// exist.
/// @throw InputError  names the line that is wrong: an unknown keyword, a point without three numbers, a
///                    face with an index that does not exist
vtkSmartPointer<vtkPolyData> readObj(const std::string& file);

#endif
