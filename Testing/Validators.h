// SPDX-License-Identifier: BSD-3-Clause
#ifndef Validators_h
#define Validators_h

#include "Base/Lists.h"
#include "Base/Types.h"

#include <algorithm>
#include <vector>

/// Checks of what the library makes, written apart from it: other algorithms, no shared code but
/// the plain types. Each has tests of its own that feed it wrong things.
namespace validators
{
using medial::Ball;
using medial::Betti;
using medial::Edge;
using medial::Index;
using medial::IndexLists;
using medial::None;
using medial::Point;
using medial::Tetrahedron;
using medial::Triangle;

/// The edge with its lower corner first.
inline Edge undirected(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

// Complexes.

/// Simplices; their faces belong to the complex without being listed.
struct Complex
{
  std::vector<Index> vertices;
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;
  std::vector<Tetrahedron> tetrahedra;
};

/// Betti numbers over Z/2 from the ranks of the boundary matrices.
/// @throw std::invalid_argument  a simplex with a repeated corner
Betti bettiNumbers(const Complex& complex);

/// Vertices - edges + triangles - tetrahedra, faces included.
Index eulerCharacteristic(const Complex& complex);

/// How many simplices of the complex are listed twice, or twice as a set of corners.
Index repeatedSimplices(const Complex& complex);

/// How many of the numbers 0 ... pointCount - 1 are a corner of nothing.
Index unusedPoints(Index pointCount, const Complex& complex);

// Groups of triangles.

/// A label for each triangle: equal where a walk over edges with exactly two triangles leads from
/// one to the other. Labels count up in the order of their first triangle.
std::vector<Index> floodFill(const std::vector<Triangle>& triangles);

/// For each label its level: 1 where one of its triangles has an edge of its own, else one more
/// than the lowest level met across an edge with three or more triangles; 0 if no walk gets there.
std::vector<int> levels(const std::vector<Triangle>& triangles, const std::vector<Index>& labels);

/// Do the two put the same things together, whatever their labels?
bool sameGroups(const std::vector<Index>& a, const std::vector<Index>& b);

// Surfaces of polygons.

/// Does every edge have exactly two faces?
bool isClosed(const IndexLists& faces);

/// Does no face run along an edge in the same direction as another?
bool isOriented(const IndexLists& faces);

/// Is it closed, and do the faces at every vertex form one fan?
bool isTwoManifold(const IndexLists& faces);

/// Vertices - edges + faces; vertices that no face uses don't count.
Index eulerCharacteristic(const IndexLists& faces);

/// The volume behind the faces: positive where they look outwards, cube of the points' unit.
double enclosedVolume(const std::vector<Point>& points, const IndexLists& faces);

/// Betti numbers of the solid behind the faces: from the genus of each piece of the surface, and
/// from whether the piece looks outwards (an object) or inwards (a void).
/// @throw std::invalid_argument  not a closed, oriented 2-manifold
Betti bettiOfSolid(const std::vector<Point>& points, const IndexLists& faces);

/// The triangles of a fan from each polygon's first corner, as polygons.
IndexLists triangulated(const IndexLists& faces);

// Distances.

/// Answers which of some points is nearest, by a sweep along x.
class NearestPoint
{
public:
  explicit NearestPoint(std::vector<Point> points);

  /// The number of the point nearest to `place`, not counting number `except`; None without points.
  Index operator()(const Point& place, Index except = None) const;

  /// The distance to it; infinite without points.
  double distance(const Point& place, Index except = None) const;

private:
  std::vector<Point> points;
  std::vector<Index> order; // ascending in x
  std::vector<double> x;    // in that order
};

/// How many points have another one at most `tolerance` away.
Index nearDuplicates(const std::vector<Point>& points, double tolerance);

/// Mean distance of a point to its nearest other.
double meanSpacing(const std::vector<Point>& points);

/// Largest distance of a point of `from` to its nearest point of `to`.
double hausdorffDistance(const std::vector<Point>& from, const std::vector<Point>& to);

/// Length of the diagonal of the bounding box.
double diagonal(const std::vector<Point>& points);

/// The point of the triangle a, b, c nearest to p; the triangle may be flat.
Point nearestOnTriangle(const Point& p, const Point& a, const Point& b, const Point& c);

/// How many points are inside the ball by more than `tolerance`.
Index pointsInside(const Ball& ball, const std::vector<Point>& points, double tolerance);

/// How far the point is outside the union of the balls; negative inside.
double clearance(const Point& point, const std::vector<Ball>& balls);

/// Six times the signed volume of the tetrahedron.
double orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// A polygonal complex as it compares under renumbering: for each polygon the set of its corners.
struct Polygons
{
  std::vector<Point> points;
  std::vector<std::vector<Index>> polygons; ///< corners in any order; edges and vertices as well
};

/// Are there points within `tolerance` of each other, one to one, that carry the polygons of `a` to
/// those of `b`?
bool samePolygons(const Polygons& a, const Polygons& b, double tolerance);
}

#endif
