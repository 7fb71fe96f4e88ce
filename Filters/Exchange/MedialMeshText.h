// SPDX-License-Identifier: BSD-3-Clause
#ifndef MedialMeshText_h
#define MedialMeshText_h

#include "Base/Execution.h"
#include "Exchange/MedialMesh.h"

#include <string>

namespace medial
{
/// The text of a .ma file with a medial mesh, see MedialMeshParser.h: points that a cell uses, all edges, and triangles.
/// Numbers have as many digits as it takes to read the same ones back, up to 17. Edges come first as they are, then the sides of
/// the triangles that are not among them, each once: importers count on all edges. A type is written where
/// points or edges have one; that of a side is 0.
///
/// parsedMedialMesh() gives the same mesh back, but for points that no cell uses, vertices at points of other
/// cells, and edges without a type that are sides of triangles.
std::string textOf(const MedialMesh& mesh, const Execution& execution);
}

#endif
