// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceBytes_h
#define SurfaceBytes_h

#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

/// Points with their array `Normals` and surface cells as bytes, to hand them from one process of this machine to another. Surface cells are
/// triangles, quads, polygons, pixels and triangle strips; others are left out.
/// @param data  may be null or without points
/// @throw InputError  offsets, corners or types of its cells, or normals and points, contradict each other
std::string bytesOf(vtkPointSet* data);

/// The points, floats or doubles as they were, their normals as doubles, and the surface cells as polygons.
/// @param file  its name, for errors
/// @throw InputError  a cell names a point that doesn't exist
vtkSmartPointer<vtkPolyData> surfaceOf(const std::string& file, const std::string& bytes);

#endif
