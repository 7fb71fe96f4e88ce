// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_FaceComplex_h
#define medial_FaceComplex_h

#include "Axis/FacePolygon.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Faces with their sides, from which faces can be collapsed one after the other.
///
/// A side is an edge of a face, or a polygon of two corners. A face can be collapsed if one of its
/// sides is free: the face goes together with this side, which changes no Betti number.
class FaceComplex
{
public:
  /// @param facePolygons  must outlive this
  FaceComplex(const std::vector<FacePolygon>& facePolygons, Index vertexCount);

  const std::vector<FacePolygon>& polygons;

  /// Has the polygon more than two corners, and was it not collapsed?
  bool isFace(Index polygon) const { return this->face[polygon]; }

  Index vertexCount() const { return count(this->goneVertex); }
  Index sideCount() const { return count(this->sides); }
  const Edge& ends(Index side) const { return this->sides[side]; }

  /// How many faces have the side; None if it is gone.
  Index faceCount(Index side) const { return this->faces[side]; }
  std::vector<Index> facesAt(Index side) const;

  /// Calls body(face) for them, without a list.
  template <typename Body>
  void forFacesAt(Index side, const Body& body) const
  {
    for (const Index p : this->users[side])
    {
      if (this->face[p])
      {
        body(p);
      }
    }
  }

  /// The sides that a polygon had at first.
  IndexLists::View sidesOf(Index polygon) const { return this->sidesOfPolygon[polygon]; }

  /// A side that no other face has, or None.
  Index freeSide(Index polygon) const;

  /// Faces joined over sides with exactly two, by their lowest ones.
  DisjointSets joinedFaces() const;

  /// The faces of each piece.
  /// @param pieceOf  pieceOf(face): the lowest face of its piece
  template <typename PieceOf>
  IndexLists facesOfPieces(const PieceOf& pieceOf) const
  {
    return listsByKey(count(this->polygons), [&](const auto& add) {
      for (Index p = 0; p < count(this->polygons); ++p)
      {
        if (this->isFace(p))
        {
          add(pieceOf(p), p);
        }
      }
    });
  }

  /// For each vertex: how many of its sides are in no face?
  std::vector<Index> danglingSides() const;

  /// Removes a face with a free side, and the chains of edges with a free end that this leaves.
  /// @return  false if it is no face or has no free side
  bool collapse(Index polygon);

  /// Collapses those of the faces that can be. @return  are all of them gone?
  bool collapseAll(const std::vector<Index>& polygonNumbers);

  /// The faces that are left, and as edges the sides that are left in none.
  std::vector<FacePolygon> remaining() const;

  /// For each vertex: is it no longer there?
  const std::vector<char>& goneVertices() const { return this->goneVertex; }

private:
  void numberSides();
  void removeChain(Index vertex);

  std::vector<char> face;   ///< for each polygon
  std::vector<Edge> sides;  ///< ascending corners
  std::vector<Index> faces; ///< how many are at each side, or None if it is gone
  IndexLists users;         ///< the polygons that each side had at first
  IndexLists sidesOfPolygon, sidesOfVertex;
  std::vector<char> goneVertex;
};
}

#endif
