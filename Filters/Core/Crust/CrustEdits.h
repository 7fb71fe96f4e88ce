// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CrustEdits_h
#define medial_CrustEdits_h

#include "Crust/CrustSurface.h"
#include "Crust/EditableTriangles.h"

#include <vector>

namespace medial
{
/// A closed crust whose edges are contracted and flipped: its samples and balls go along.
class CrustEdits
{
public:
  explicit CrustEdits(CrustSurface& surface)
    : crust(surface)
    , edits(surface.triangles, count(surface.points))
  {
  }

  /// Of the points and triangles some may be gone: of such a triangle the corners are None.
  const CrustSurface& surface() const { return this->crust; }
  EditableTriangles& triangles() { return this->edits; }

  const Point& at(Index point) const { return this->crust.points[point]; }
  bool isSample(Index point) const { return this->crust.sampleOfPoint[point] != None; }

  /// For each point: is it the corner of a triangle?
  std::vector<char> usedPoints() const;

  /// From a point to the middle of its neighbours.
  Point towardsNeighbors(Index point);

  /// Makes the ends of an edge one point: a sample, if one of them is, since samples are exact.
  /// @return  false if refused, see EditableTriangles::contract
  bool contract(const Edge& edge);

  /// Replaces a triangle without an area and its neighbour across the edge opposite to a corner by those
  /// with the other diagonal. Both take over the balls of the neighbour.
  /// @return  false if refused, see EditableTriangles::flip
  bool flip(Index triangle, int corner);

  /// Moves a point. It is no sample any more.
  void move(Index point, const Point& by);

  /// Drops the points and triangles that are gone; the others keep their order. Ends the editing.
  void finish();

private:
  CrustSurface& crust;
  EditableTriangles edits;
};
}

#endif
