// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_MedialMesh_h
#define Conversion_MedialMesh_h

#include "Exchange/MedialMesh.h"

class vtkPolyData;

namespace medial
{
void write(const MedialMesh& mesh, vtkPolyData* output);

/// @throw InvalidInput  a cell is neither vertex, line nor triangle, a point has no radius, or a type doesn't fit
MedialMesh readMedialMesh(vtkPolyData* input);
}

#endif
