// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadPly_h
#define ReadPly_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

/// The points and polygons of a .ply file: x, y, z of its element vertex, and normals where it has all of
/// nx, ny, nz; the list vertex_indices or
/// vertex_index of its element face. ASCII and binary of either byte order; other elements and properties
/// are checked and left out. Coordinates stay what they are: float where all three are binary floats,
/// double otherwise.
///
/// VTK 9.1's reader cuts doubles to floats, reads cut files in part, and crashes where counts and
/// content disagree; so this one checks each count against what is there.
/// @throw InputError  names the line, or the row and the byte, where file and header disagree
vtkSmartPointer<vtkPolyData> readPly(const std::string& file);

#endif
