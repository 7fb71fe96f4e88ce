// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/SiteTriangulation.h"

#include "Balls/PowerLocator.h"
#include "Base/Lists.h"
#include "Base/Predicates.h"
#include "Base/Triangulations.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

// A Voronoi vertex of the sites is kept if it is inside the solid. Most are the poles of inner balls,
// which the cell's corners share: that is decided by ids. Any other centre is located in the power shape.
// Being in the shape decides for inside. Of the rest, centres that are nearer (in power) to an inner ball
// than to an outer one may be inside; their depth says how likely that is, and Carving.h decides.
//
// The triangulation takes O(n log n) time for n sites as they come from surfaces. A cell is classified
// by a walk through the power shape from a nearby ball, which crosses few cells.

namespace medial
{
namespace
{
/// What decides about a cell that is on no ball.
struct Classifier
{
  /// Is a point of a cell outside the shape on a lower simplex of the shape, up to rounding? Where
  /// the axis is a plane the tetrahedra of the shape have no volume.
  bool isOnShape(const Point& p, Index cell) const
  {
    std::vector<Point> inner;
    for (const Index ball : this->polarBalls.triangulation.cells[cell])
    {
      if (this->polarBalls.sides[ball] == Side::Inner)
      {
        inner.push_back(this->locator.balls()[ball].center);
      }
    }
    if (inner.empty())
    {
      return false;
    }
    Point offset = p - inner[0];
    if (inner.size() == 2)
    {
      const Point along = (inner[1] - inner[0]).normalized();
      offset -= offset.dot(along) * along;
    }
    else if (inner.size() == 3)
    {
      const Point normal = (inner[1] - inner[0]).cross(inner[2] - inner[0]).normalized();
      offset = offset.dot(normal) * normal;
    }
    return offset.norm() < coincident;
  }

  /// The radius of the largest inner ball through a corner, for the corner where that is smallest.
  double leastBall(const Tetrahedron& corners) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Index site : corners)
    {
      least = std::min(least, this->largestBall[site]);
    }
    return least;
  }

  /// A cell of a ball at one of the corners, one that is likely to be near to a point.
  Index cellNear(const Point& p, const Tetrahedron& corners) const
  {
    Index best = this->sites.balls[corners[0]][0];
    double least = std::numeric_limits<double>::infinity();
    for (const Index site : corners)
    {
      for (const Index ball : this->sites.balls[site])
      {
        const double remoteness = this->locator.remoteness(p, ball);
        best = remoteness < least ? ball : best;
        least = std::min(least, remoteness);
      }
    }
    return this->locator.cellTowards(p, best);
  }

  const PolarBalls& polarBalls;
  const PowerShape& shape;
  const SingularPoints& sites;
  const PowerLocator& locator;
  const std::vector<double>& largestBall; ///< through each site
  Eigen::AlignedBox3d box;                ///< of the samples

  void classify(Index c, SiteTriangulation& result) const
  {
    const Ball& sphere = result.spheres[c];
    const Tetrahedron& corners = result.mesh.cells[c];
    result.depth[c] = -sphere.radius / this->leastBall(corners);
    if (!this->box.contains(sphere.center))
    {
      return; // no walk towards a centre that may be far off
    }
    const Index cell = this->locator.locate(sphere.center, this->cellNear(sphere.center, corners));
    if (cell == None)
    {
      return;
    }
    result.isCore[c] = this->shape.contains[cell] || this->isOnShape(sphere.center, cell);
    const Index nearest = this->locator.nearestBall(sphere.center, cell);
    if (result.isCore[c] || this->polarBalls.sides[nearest] == Side::Inner)
    {
      result.depth[c] = -result.depth[c];
    }
  }
};

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
  result.mesh = delaunay(points, execution.between(0, 0.5));
  result.siteCount = count(points);
  result.edges = edgeNumbers(result.mesh.cells, result.siteCount);
  execution.report(0.6);

  const Index cellCount = count(result.mesh.cells);
  const PowerLocator locator(polarBalls.triangulation, polarBalls.balls, frame);
  const std::vector<Ball>& balls = locator.balls();
  const std::vector<double> largest = largestBalls(sites, balls);
  const Eigen::AlignedBox3d box = boundingBox(polarBalls.samples);
  const Classifier classifier{ polarBalls, shape, sites, locator, largest,
    { frame.toLocal(box.min()), frame.toLocal(box.max()) } };
  result.spheres.resize(cellCount);
  result.onBall.assign(cellCount, None);
  result.isCore.assign(cellCount, 0);
  result.depth.assign(cellCount, 0);
  execution.forEach(cellCount, [&](Index c) {
    const Tetrahedron& v = result.mesh.cells[c];
    const Index ball = lowestCommonItem(sites.balls, v);
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
