// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SurfaceTree_h
#define medial_SurfaceTree_h

#include "Base/Types.h"

#include <memory>
#include <optional>
#include <vector>

namespace medial
{
/// How far a point is from the triangle a b c, an area or not.
double distanceToTriangle(const Point& point, const Point& a, const Point& b, const Point& c);

/// Finds the nearest point of a triangulated surface, the triangle that a way meets first, and whether
/// a point is enclosed. Built in O(n log n); a search takes about O(log n). Threads may search at the
/// same time.
class SurfaceTree
{
public:
  /// @param triangles  those without an area are left out; the surface that they belong to is closed where
  ///                   encloses() is asked
  SurfaceTree(const std::vector<Point>& points, const std::vector<Triangle>& triangles);
  SurfaceTree(SurfaceTree&& other) noexcept;
  ~SurfaceTree();

  struct Place
  {
    Point point;
    Index triangle;
  };

  /// The point of the surface that is nearest to `point`.
  /// @param near  one that is not much farther, if it is known: then this takes less time
  Place nearest(const Point& point, const std::optional<Place>& near = {}) const;

  /// How far a point is from one triangle, an area or not.
  double distance(const Point& point, Index triangle) const;

  /// Where the straight way between two points first meets a triangle other than `skipped`, if it does. A
  /// search takes as long as there are triangles on the way.
  std::optional<Place> firstMet(const Point& from, const Point& to, Index skipped) const;

  /// Is the point inside the closed surface? Exact; a point on the surface is not inside.
  bool encloses(const Point& point) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};
}

#endif
