// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Trimming.h"

#include "Axis/FaceComplex.h"
#include "Axis/SheetSeparation.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <algorithm>
#include <utility>

// Beside a sheet, Voronoi faces can form slivers: small pieces all of whose poles are also poles of the
// sheet. Each would be a part of its own. Unlike the paper, we leave them out, because they add nothing
// to the union of balls. Every step is a collapse of a face through a free side, so the Betti numbers
// stay by construction. A piece without a free side stays, such as a wall between two voids.
//
// Removing pieces takes O(n log n) time for n faces; SheetSeparation.cxx tells what the cuts take.

namespace medial
{
namespace
{
/// Collapses the pieces all of whose poles are elsewhere, too.
/// @param pieceOf  pieceOf(face): the lowest face of its piece
template <typename PieceOf>
void removePieces(FaceComplex& faces, const FaceGeometry& geometry, const PieceOf& pieceOf)
{
  const Index polygonCount = count(faces.polygons);
  const IndexLists facesOfPiece = faces.facesOfPieces(pieceOf);
  IndexLists verticesOfPiece;
  std::vector<Index> lastPiece(faces.vertexCount(), None);
  std::vector<Index> uses = faces.danglingSides(); // and pieces, at each vertex
  for (Index piece = 0; piece < polygonCount; ++piece)
  {
    for (const Index p : facesOfPiece[piece])
    {
      for (const Index v : faces.polygons[p].corners)
      {
        if (lastPiece[v] != piece)
        {
          lastPiece[v] = piece;
          verticesOfPiece.items.push_back(v);
          ++uses[v];
        }
      }
    }
    verticesOfPiece.close();
  }
  for (Index piece = 0; piece < polygonCount; ++piece)
  {
    const IndexLists::View own = facesOfPiece[piece];
    const IndexLists::View vertices = verticesOfPiece[piece];
    const bool isNeeded = std::any_of(vertices.begin(), vertices.end(),
      [&](Index v) { return geometry.ball[v] != None && uses[v] == 1; });
    if (!isNeeded && faces.collapseAll({ own.begin(), own.end() }))
    {
      // The poles may now be those of one other piece alone, which then has to stay.
      std::for_each(vertices.begin(), vertices.end(), [&uses](Index v) { --uses[v]; });
    }
  }
}

/// Pieces as Sheets tells them apart.
void removeSlivers(FaceComplex& faces, const FaceGeometry& geometry)
{
  Sheets sheets(faces, geometry);
  sheets.findPieces();
  removePieces(faces, geometry, [&sheets](Index p) { return sheets.pieceOf(p); });
}

/// @param polygons  of the faces; only what is left stays
/// @return  for each vertex: is it gone?
std::vector<char> takeRemaining(const FaceComplex& faces, std::vector<FacePolygon>& polygons)
{
  std::vector<char> gone = faces.goneVertices();
  polygons = faces.remaining();
  return gone;
}

/// Pieces joined over sides with exactly two faces.
void removeFlaps(FaceComplex& faces, const FaceGeometry& geometry)
{
  DisjointSets pieces = faces.joinedFaces();
  removePieces(faces, geometry, [&pieces](Index p) { return pieces.find(p); });
}
}

std::vector<char> trimSheets(
  const FaceGeometry& geometry, std::vector<FacePolygon>& polygons, const Execution& execution)
{
  FaceComplex faces(polygons, count(geometry.points));
  execution.poll();
  removeSlivers(faces, geometry);
  execution.poll();
  separateSheets(faces, geometry);
  execution.poll();
  removeSlivers(faces, geometry); // a cut may have left new slivers
  execution.poll();
  return takeRemaining(faces, polygons);
}

std::vector<char> trimFlaps(
  const FaceGeometry& geometry, std::vector<FacePolygon>& polygons, const Execution& execution)
{
  FaceComplex faces(polygons, count(geometry.points));
  // What a flap has left may be a flap now. A third round would find next to nothing.
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round)
  {
    execution.poll();
    removeFlaps(faces, geometry);
  }
  return takeRemaining(faces, polygons);
}
}
