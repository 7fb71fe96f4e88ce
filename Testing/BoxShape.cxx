// SPDX-License-Identifier: BSD-3-Clause
#include "PoissonDisk.h"
#include "Shapes.h"
#include "Validators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shapes
{
namespace
{
using Corner = std::array<Point, 4>;

/// The sheets of the medial axis of the box with these half sides, longest first: one to each edge
/// of the box, and the rectangle in the middle.
std::vector<Corner> boxSheets(const Point& half)
{
  const Point middle = half - Point::Constant(half.z());
  std::vector<Corner> sheets;
  for (int edge = 0; edge < 12; ++edge)
  {
    const int along = edge / 4;
    Point from, to;
    from[along] = -1;
    to[along] = 1;
    from[(along + 1) % 3] = to[(along + 1) % 3] = edge % 2 == 0 ? -1 : 1;
    from[(along + 2) % 3] = to[(along + 2) % 3] = edge / 2 % 2 == 0 ? -1 : 1;
    sheets.push_back({ from.cwiseProduct(half), to.cwiseProduct(half), to.cwiseProduct(middle),
      from.cwiseProduct(middle) });
  }
  const double x = middle.x(), y = middle.y();
  sheets.push_back({ Point(-x, -y, 0), Point(x, -y, 0), Point(x, y, 0), Point(-x, y, 0) });
  return sheets;
}

double distanceToSheets(const Point& p, const std::vector<Corner>& sheets)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Corner& c : sheets)
  {
    const Point first = validators::nearestOnTriangle(p, c[0], c[1], c[2]);
    const Point second = validators::nearestOnTriangle(p, c[0], c[2], c[3]);
    least = std::min({ least, (first - p).norm(), (second - p).norm() });
  }
  return least;
}

/// The box's corners, and points evenly on its edges.
std::vector<Point> boxEdges(const Point& half, double spacing)
{
  std::vector<Point> result;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Point signs(corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1);
    result.push_back(signs.cwiseProduct(half));
    for (int along = 0; along < 3; ++along)
    {
      const int pieces = static_cast<int>(std::round(2 * half[along] / spacing));
      for (int i = 1; signs[along] < 0 && i < pieces; ++i)
      {
        Point point = signs.cwiseProduct(half);
        point[along] = half[along] * (2.0 * i / pieces - 1);
        result.push_back(point);
      }
    }
  }
  return result;
}

Draw boxFaces(const Point& half)
{
  return [half](Random& random) {
    const double xy = half.x() * half.y(), yz = half.y() * half.z(), zx = half.z() * half.x();
    const double pick = uniform(random, 0, xy + yz + zx);
    const int across = pick < xy ? 2 : pick < xy + yz ? 0 : 1;
    Point point = uniformInBox(random, half);
    point[across] = point[across] < 0 ? -half[across] : half[across];
    return point;
  };
}

double distanceToBox(const Point& p, const Point& half)
{
  const Point beyond = p.cwiseAbs() - half;
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
}
}

Shape box(double spacing, unsigned seed)
{
  const Point half(1.5, 1, 0.5);
  Shape shape;
  shape.name = "box";
  shape.spacing = 0.85 * spacing;
  shape.samples = poissonDisk(boxFaces(half), shape.spacing, seed, boxEdges(half, spacing));
  shape.seed = seed;
  shape.betti = { 1, 0, 0 };
  shape.volume = 8 * half.prod();
  shape.smooth = false;
  shape.outside = [half](const Point& p) { return distanceToBox(p, half); };
  shape.axisDistance = [sheets = boxSheets(half)](
                         const Point& p) { return distanceToSheets(p, sheets); };
  return shape;
}
}
