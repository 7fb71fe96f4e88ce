// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Sheets_h
#define medial_Sheets_h

#include "Axis/FaceComplex.h"
#include "Base/DisjointSets.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Where the vertices of faces are, and what the faces are equally far from. In a frame.
struct FaceGeometry
{
  std::vector<Point> points;   ///< of the vertices
  std::vector<Index> ball;     ///< the pole that each vertex is, or None
  std::vector<Point> sites;    ///< singular points
  std::vector<Edge> siteEdges; ///< by FacePolygon::siteEdge: the two sites of a face
  double spacing = 0;          ///< mean distance of a sample to the nearest other one
};

/// Pieces of faces. Two kinds of them are told apart: pieces, which count what touches smoothly as one, and
/// sheets, which are what parts will be after pruning has taken the small ones away.
///
/// Two faces turn at a side if one of their sites moves, from one face to the other, farther than its
/// distance from the side. For example, the three sheets of a solid with a Y as cross-section turn
/// pairwise at the line where they meet; neighbouring faces of one sheet do not.
class Sheets
{
public:
  /// No pieces yet.
  /// @param faceComplex, faceGeometry  must outlive this
  Sheets(const FaceComplex& faceComplex, const FaceGeometry& faceGeometry);

  /// Finds pieces among the faces that are there now, in linear time: faces that are the only two at a side,
  /// or do not turn there, are one piece.
  void findPieces();

  /// Finds sheets among the faces that are there now, in linear time. Faces that are the only two at a side
  /// are one piece. A piece with a face that has no vertex at the border is a sheet if it is larger than two square
  /// spacings, as pruning takes what is smaller by default (the scrap of a sheet at a corner of a box); any other is a
  /// sliver. Then the same without the slivers: each sheet becomes a piece.
  void findSheets();

  /// The lowest face of a face's piece.
  Index pieceOf(Index polygon) { return this->pieces.find(polygon); }

  /// The faces at a side that are in sheets, as findSheets() found them.
  std::vector<Index> sheetsAt(Index side);

  bool turns(Index side, Index p, Index q) const;

  /// Are there three of these faces at a side that turn pairwise?
  bool isTripod(Index side, const std::vector<Index>& facesAtSide) const;

  /// Do three sheets meet at the side?
  bool isSeam(Index side);

private:
  double cosine(Index vertex, const Edge& p, const Edge& q) const;
  void findSheetsAmong(const std::vector<char>& isIn);

  const FaceComplex& faces;
  const FaceGeometry& geometry;
  DisjointSets pieces;       ///< of faces, when they were last found
  std::vector<char> isSheet; ///< of the pieces by their lowest faces
  std::vector<double> areas; ///< of the polygons, once findSheets() has needed them
};
}

#endif
