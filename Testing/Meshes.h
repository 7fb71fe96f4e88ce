// SPDX-License-Identifier: BSD-3-Clause
#ifndef Meshes_h
#define Meshes_h

#include "Base/Lists.h"
#include "Base/Types.h"

#include <functional>
#include <vector>

/// Surfaces of solids that are known exactly, as they lie in a file. Made, not stored.
namespace meshes
{
using medial::Betti;
using medial::Index;
using medial::IndexLists;
using medial::Point;
using medial::Triangle;

/// Polygons, counter-clockwise seen from outside.
struct Mesh
{
  std::vector<Point> points;
  IndexLists polygons;
};

/// The cells of a grid for which `filled(i, j, k)` holds, bounded by rectangles. Cell i is between xs[i] and
/// xs[i + 1].
Mesh blocks(const std::vector<double>& xs, const std::vector<double>& ys,
  const std::vector<double>& zs, const std::function<bool(int, int, int)>& filled);

/// Between two corners; six rectangles.
Mesh box(const Point& low, const Point& high);

/// From 0 to (4, 4, thickness), with a square hole from 1.5 to 2.5; volume 15 thickness.
Mesh drilledPlate(double thickness);

/// An I-beam from 0 to (3, 3, length): flanges and web are 1 thick. Its caps are cut into squares, so that
/// corners lie on the straight edges. Volume 7 length.
Mesh iBeam(double length);

/// The tetrahedron with corners at 0 and the three unit vectors, and a point in the middle of its edge along x.
/// That point is a corner of two triangles on one side; on the other it is a corner of a triangle
/// whose corners are on a line.
Mesh tetrahedronWithFlatTriangle();

/// Around the z axis, cut into squares.
Mesh torus(double large = 2, double small = 0.7, int around = 40, int across = 20);

/// Around 0; the poles are on the z axis.
Mesh sphere(double radius = 1, int around = 32);

/// Around the z axis, from 0 to `height`; the caps are polygons.
Mesh cylinder(double radius, double height, int around = 48);

/// Over the triangle (0, 0), (1, 0), (0, tan(angle)), 1 high: two sides meet at `angle` along z.
Mesh wedge(double degrees);

// Changes.

Mesh moved(Mesh mesh, const Point& by);
Mesh scaled(Mesh mesh, double factor);

/// Each turned around: the surface of a void.
Mesh reversed(const Mesh& mesh);

/// Both side by side.
Mesh united(const Mesh& a, const Mesh& b);

/// Polygons are cut into fans.
Mesh triangulated(const Mesh& mesh);

/// Each polygon has its own points, as in a .stl file.
Mesh soup(const Mesh& mesh);

/// Without some polygons.
Mesh without(const Mesh& mesh, const std::function<bool(Index polygon)>& dropped);

/// The polygons, which are triangles.
std::vector<Triangle> triangles(const Mesh& mesh);
}

#endif
