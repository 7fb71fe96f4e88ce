// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Trimming.h"

#include "Axis/FaceComplex.h"
#include "Axis/SheetSeparation.h"
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
void removePieces(FaceComplex& faces, const FaceGeometry& geometry)
{
  Sheets sheets(faces, geometry);
  sheets.findPieces();
  const Index polygonCount = count(faces.polygons);
  const IndexLists facesOfPiece = listsByKey(polygonCount, [&](const auto& add) {
    for (Index p = 0; p < polygonCount; ++p)
    {
      if (faces.isFace(p))
      {
        add(sheets.pieceOf(p), p);
      }
    }
  });
  std::vector<std::vector<Index>> verticesOfPiece(polygonCount);
  std::vector<Index> uses = faces.danglingSides(); // and pieces, at each vertex
  for (Index piece = 0; piece < polygonCount; ++piece)
  {
    std::vector<Index>& vertices = verticesOfPiece[piece];
    for (const Index p : facesOfPiece[piece])
    {
      const std::vector<Index>& corners = faces.polygons[p].corners;
      vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    sortUnique(vertices);
    std::for_each(vertices.begin(), vertices.end(), [&uses](Index v) { ++uses[v]; });
  }
  for (Index piece = 0; piece < polygonCount; ++piece)
  {
    const IndexLists::View own = facesOfPiece[piece];
    const std::vector<Index>& vertices = verticesOfPiece[piece];
    const bool isNeeded = std::any_of(vertices.begin(), vertices.end(),
      [&](Index v) { return geometry.ball[v] != None && uses[v] == 1; });
    if (!isNeeded && faces.collapseAll({ own.begin(), own.end() }))
    {
      // The poles may now be those of one other piece alone, which then has to stay.
      std::for_each(vertices.begin(), vertices.end(), [&uses](Index v) { --uses[v]; });
    }
  }
}
}

std::vector<char> trimSheets(
  const FaceGeometry& geometry, std::vector<FacePolygon>& polygons, const Execution& execution)
{
  FaceComplex faces(polygons, count(geometry.points));
  execution.poll();
  removePieces(faces, geometry);
  execution.poll();
  separateSheets(faces, geometry);
  execution.poll();
  removePieces(faces, geometry); // a cut may have left new slivers
  execution.poll();
  std::vector<FacePolygon> remaining = faces.remaining();
  std::vector<char> gone = faces.goneVertices();
  polygons = std::move(remaining);
  return gone;
}
}
