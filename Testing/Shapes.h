// SPDX-License-Identifier: BSD-3-Clause
#ifndef Shapes_h
#define Shapes_h

#include "Base/Types.h"

#include <functional>
#include <string>
#include <vector>

/// Samples of solids that are known exactly. Made, not stored; the same seed gives the same
/// samples.
namespace shapes
{
using medial::Betti;
using medial::Index;
using medial::Point;

/// A solid and samples of its boundary.
struct Shape
{
  std::string name;
  std::vector<Point> samples; ///< no two nearer than the spacing, no gap left for another one
  unsigned seed;              ///< that the samples were drawn with
  double spacing;
  Betti betti;   ///< of the solid
  double volume; ///< of the solid
  bool smooth;   ///< without sharp edges

  /// Distance to the boundary, negative inside. (Of the ellipsoid: right in sign, and near 0.)
  std::function<double(const Point&)> outside;

  /// Distance to the solid's exact medial axis.
  std::function<double(const Point&)> axisDistance;
};

Shape sphere(double spacing = 0.17, unsigned seed = 1);       ///< radius 1
Shape ellipsoid(double spacing = 0.16, unsigned seed = 1);    ///< half axes 3, 2, 1 by 0.5
Shape torus(double spacing = 0.2, unsigned seed = 1);         ///< radii 2 and 0.7
Shape capsule(double spacing = 0.13, unsigned seed = 1);      ///< length 3, radius 0.5
Shape knot(double spacing = 0.17, unsigned seed = 1);         ///< trefoil tube, radius 0.35
Shape twoHolePlate(double spacing = 0.09, unsigned seed = 1); ///< 2.8 x 1.6 rounded by 0.2
Shape hollowSphere(double spacing = 0.11, unsigned seed = 1); ///< between radii 0.5 and 1
Shape twoObjects(double spacing = 0.13, unsigned seed = 1);   ///< a sphere and a torus
Shape box(double spacing = 0.1, unsigned seed = 1);           ///< 3 x 2 x 1, sharp

/// A sphere of radius 1 with two flat ears, ellipsoids at x = -1 and x = 1. Without the exact axis and
/// volume, and not among all().
Shape head(double spacing = 0.07, unsigned seed = 1);

/// All of the first nine with their default spacing.
const std::vector<Shape>& all();

/// Points of a regular grid on the boundary of a cube: massively cospherical.
std::vector<Point> gridCube(int perEdge);

/// A sphere's samples without those above z = 0.3: no solid at all.
std::vector<Point> openBowl();

/// Random points in a cube of side 1: no surface.
std::vector<Point> cloud(int size, unsigned seed);

// Motions.

std::vector<Point> scaled(std::vector<Point> points, double factor);
/// As they come from a file of floats.
std::vector<Point> roundedToFloats(std::vector<Point> points);

std::vector<Point> moved(std::vector<Point> points, const Point& by);
std::vector<Point> rotated(std::vector<Point> points, unsigned seed, bool back = false);

/// The numbers 0 ... size - 1 in random order.
std::vector<Index> shuffledOrder(std::size_t size, unsigned seed);

/// points[order[0]], points[order[1]], ...
std::vector<Point> reordered(const std::vector<Point>& points, const std::vector<Index>& order);
}

#endif
