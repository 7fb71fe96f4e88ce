// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadXml_h
#define ReadXml_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

/// The points of a .vtp file, floats or doubles as there, their array `Normals`, and its polygons, triangle strips as triangles.
///
/// VTK's reader does the work. VTK 9.1's crashes, runs away or asks for all memory on some damaged files,
/// so it works in a process of its own, with limits that follow from the size of the file.
/// @throw InputError  the file can't be read; says why
vtkSmartPointer<vtkPolyData> readVtp(const std::string& file);

/// The same of a .vtu file: of its cells the triangles, quads, polygons, pixels and triangle strips.
vtkSmartPointer<vtkPolyData> readVtu(const std::string& file);

#endif
