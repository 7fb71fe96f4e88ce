// SPDX-License-Identifier: BSD-3-Clause
#ifndef PartMeshes_h
#define PartMeshes_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkPolyData;
class vtkTable;

/// A part of the pruned axis with its share of the simplified surface.
struct PartMesh
{
  vtkIdType part = 0;        ///< its `PartId`
  double relativeVolume = 0; ///< its measure, a share of the volume
  vtkSmartPointer<vtkPolyData>
    patch;               ///< the triangles of the surface that belong to it, with their points
  bool isClosed = false; ///< has each edge of the patch two triangles?

  /// The name of its file; "" if it has no triangles, and so no file.
  std::string file() const;
};

/// The meshes of all parts, largest volume first, of equal ones the lowest id first. Where parts touch each other, the surface
/// ends: nothing closes their patches there. Triangles that belong to no part (PartId -1) are in none.
/// @throw InputError  an array is missing
std::vector<PartMesh> partMeshes(vtkPolyData* prunedAxis, vtkPolyData* surface);

/// A row for each: `PartId File RelativeVolume Triangles Closed`.
vtkSmartPointer<vtkTable> tableOf(const std::vector<PartMesh>& meshes);

#endif
