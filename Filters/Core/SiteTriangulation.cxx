// SPDX-License-Identifier: BSD-3-Clause
#include "SiteTriangulation.h"

#include "Predicates.h"
#include "Triangulations.h"

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{
/// The lowest ball that is in the lists of all four corners, or None.
Index commonBall(const IndexLists& balls, const Tetrahedron& corners)
{
  for (const Index ball : balls[corners[0]])
  {
    const auto passesThrough = [&](Index corner) {
      const IndexLists::View list = balls[corner];
      return std::binary_search(list.begin(), list.end(), ball);
    };
    if (passesThrough(corners[1]) && passesThrough(corners[2]) && passesThrough(corners[3]))
    {
      return ball;
    }
  }
  return None;
}

/// Finds the cell of the balls' triangulation that contains a point, by walking.
struct Locator
{
  const Tetrahedra& mesh;
  const std::vector<Ball>& balls;    ///< local
  const std::vector<Index> cellAtBall;

  /// @return  None outside the convex hull
  Index locate(const Point& p, Index start) const
  {
    // A visibility walk ends in a regular triangulation; the limit is for cells that rounding turned.
    constexpr int stepLimit = 100000;
    Index cell = start, from = None;
    for (int step = 0; step < stepLimit && cell != None; ++step)
    {
      int k = 0;
      for (; k < 4; ++k)
      {
        const int i = (step + k) % 4;
        const Index next = this->mesh.neighbors[cell][i];
        if ((next == None || next != from) && this->isBeyond(p, cell, i))
        {
          from = cell;
          cell = next;
          break;
        }
      }
      if (k == 4)
      {
        return cell;
      }
    }
    return None;
  }

  /// The ball of the cell with the least power at a point.
  Index nearestBall(const Point& p, Index cell) const
  {
    const auto power = [&](Index b) {
      return (this->balls[b].center - p).squaredNorm() - this->balls[b].radius * this->balls[b].radius;
    };
    const Tetrahedron& corners = this->mesh.cells[cell];
    return *std::min_element(
      corners.begin(), corners.end(), [&](Index a, Index b) { return power(a) < power(b); });
  }

private:
  bool isBeyond(const Point& p, Index cell, int side) const
  {
    const Triangle t = facet(this->mesh.cells[cell], side);
    return orientation(
             this->balls[t[0]].center, this->balls[t[1]].center, this->balls[t[2]].center, p) < 0;
  }
};

std::vector<Index> cellAtBall(const Tetrahedra& mesh, Index ballCount)
{
  std::vector<Index> result(ballCount, None);
  for (Index c = 0; c < count(mesh.cells); ++c)
  {
    for (const Index ball : mesh.cells[c])
    {
      result[ball] = c;
    }
  }
  return result;
}

/// What decides about a cell that is on no ball.
struct Classifier
{
  const PolarBalls& polarBalls;
  const PowerShape& shape;
  const SingularPoints& sites;
  const Locator& locator;
  const std::vector<double>& largestBall; ///< through each site
  Point lower, upper;                     ///< of the samples

  void classify(Index c, SiteTriangulation& result) const
  {
    const Ball& sphere = result.spheres[c];
    if ((sphere.center.array() < this->lower.array()).any() ||
      (sphere.center.array() > this->upper.array()).any())
    {
      return;
    }
    const Tetrahedron& corners = result.mesh.cells[c];
    const Index start = this->locator.cellAtBall[this->sites.balls[corners[0]][0]];
    const Index cell = this->locator.locate(sphere.center, start);
    if (cell == None)
    {
      return;
    }
    result.isCore[c] = this->shape.contains[cell];
    const Index nearest = this->locator.nearestBall(sphere.center, cell);
    if (result.isCore[c] || this->polarBalls.sides[nearest] == Side::Inner)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const Index site : corners)
      {
        least = std::min(least, this->largestBall[site]);
      }
      result.depth[c] = sphere.radius / least;
    }
  }
};

std::vector<Ball> localBalls(const std::vector<Ball>& balls, const Frame& frame)
{
  std::vector<Ball> result(balls.size());
  std::transform(balls.begin(), balls.end(), result.begin(),
    [&](const Ball& ball) { return frame.toLocal(ball); });
  return result;
}

std::vector<double> largestBalls(const SingularPoints& sites, const std::vector<Ball>& balls)
{
  std::vector<double> result(sites.positions.size(), 0);
  for (Index s = 0; s < count(result); ++s)
  {
    for (const Index ball : sites.balls[s])
    {
      result[s] = std::max(result[s], balls[ball].radius);
    }
  }
  return result;
}
}

SiteTriangulation siteTriangulation(const PolarBalls& polarBalls, const PowerShape& shape,
  const SingularPoints& sites, const Frame& frame, const Execution& execution)
{
  std::vector<Point> points(sites.positions.size());
  std::transform(sites.positions.begin(), sites.positions.end(), points.begin(),
    [&](const Point& p) -> Point { return frame.toLocal(p); });
  SiteTriangulation result;
  result.mesh = delaunay(points, execution.part(0, 0.5));
  result.siteCount = count(points);
  result.edges = edgeNumbers(result.mesh.cells, result.siteCount);
  execution.report(0.6);

  const Index cellCount = count(result.mesh.cells);
  const std::vector<Ball> balls = localBalls(polarBalls.balls, frame);
  const std::vector<double> largest = largestBalls(sites, balls);
  const Locator locator{ shape.triangulation, balls,
    cellAtBall(shape.triangulation, count(balls)) };
  Classifier classifier{ polarBalls, shape, sites, locator, largest, points[0], points[0] };
  for (const Point& sample : polarBalls.samples)
  {
    classifier.lower = classifier.lower.cwiseMin(frame.toLocal(sample));
    classifier.upper = classifier.upper.cwiseMax(frame.toLocal(sample));
  }
  result.spheres.resize(cellCount);
  result.onBall.assign(cellCount, None);
  result.isCore.assign(cellCount, 0);
  result.depth.assign(cellCount, -1);
  execution.forEach(cellCount, [&](Index c) {
    const Tetrahedron& v = result.mesh.cells[c];
    const Index ball = commonBall(sites.balls, v);
    result.onBall[c] = ball;
    if (ball != None)
    {
      result.spheres[c] = balls[ball];
      result.isCore[c] = 1;
      result.depth[c] = 1;
      return;
    }
    result.spheres[c] =
      circumsphere({ points[v[0]], points[v[1]], points[v[2]], points[v[3]] }, constructionError);
    classifier.classify(c, result);
  });
  execution.report(1);
  return result;
}
}
