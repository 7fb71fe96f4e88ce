// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Trimming.h"

#include "Axis/FaceComplex.h"
#include "Axis/SheetSeparation.h"
#include "Base/Lists.h"

#include <algorithm>
#include <utility>

// The Voronoi faces of the sites contain slivers: small faces beside a sheet that come from sites which
// are nearly on one sphere. They would be parts of their own, hundreds in a model, with no ball that
// another part does not have. Unlike the paper, which leaves them to pruning, they go here, where a
// face is still known by its sites. Every step is a collapse, so the Betti numbers stay by construction.
// Each step takes time linear in the faces.

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

std::vector<char> trimSheets(const FaceGeometry& geometry, std::vector<FacePolygon>& polygons)
{
  FaceComplex faces(polygons, count(geometry.points));
  removePieces(faces, geometry);
  separateSheets(faces, geometry);
  removePieces(faces, geometry); // a cut may have left new slivers
  std::vector<FacePolygon> remaining = faces.remaining();
  std::vector<char> gone = faces.goneVertices();
  polygons = std::move(remaining);
  return gone;
}
}
