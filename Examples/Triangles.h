// SPDX-License-Identifier: BSD-3-Clause
#ifndef Triangles_h
#define Triangles_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

/// The same surface with each polygon cut into triangles from its first corner. The faces of a power
/// crust are convex, and what was closed stays closed, however thin a face is.
vtkSmartPointer<vtkPolyData> inTriangles(vtkPolyData* surface);

#endif
