// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/SingularPoints.h"

#include "Axis/TriangleSites.h"
#include "Balls/PowerLocator.h"
#include "Base/Frame.h"
#include "Base/Lists.h"

#include <algorithm>
#include <optional>

namespace medial
{
namespace
{
/// Is a point that lies on inner balls inside no other one?
/// @param near  a cell with these balls
bool isOnUnion(
  const PowerLocator& locator, const std::vector<Side>& sides, const Point& p, Index near)
{
  const Index cell = locator.locate(p, near);
  if (cell == None)
  {
    return true;
  }
  const Index nearest = locator.nearestBall(p, cell);
  const Ball& other = locator.balls()[nearest];
  return sides[nearest] != Side::Inner || (p - other.center).norm() > other.radius - coincident;
}

/// The balls of a triangle, turned so that they are counter-clockwise seen from its side `side`.
Triangle seenFrom(const Tetrahedra& mesh, const ShapeTriangle& triangle, int side)
{
  // Seen from the corner of the other cell they would be counter-clockwise in the wrong sense.
  const Index own = triangle.cells[side];
  const Index cell = own != None ? own : triangle.cells[1 - side];
  for (int i = 0; i < 4; ++i)
  {
    Triangle balls = facet(mesh.cells[cell], i), sorted = balls;
    std::sort(sorted.begin(), sorted.end());
    if (sorted == triangle.balls)
    {
      if (own == None)
      {
        std::swap(balls[1], balls[2]);
      }
      return balls;
    }
  }
  return triangle.balls;
}

/// The singular points that are no samples, each with its balls.
struct Crossing
{
  Triangle balls;
  Point position;
};

std::vector<Crossing> crossings(const PolarBalls& polarBalls, const PowerShape& shape,
  const Frame& frame, const Execution& execution)
{
  const PowerLocator locator(polarBalls.triangulation, polarBalls.balls, frame);
  std::vector<std::optional<Crossing>> found(2 * shape.triangles.size());
  execution.forEach(count(found), [&](Index i) {
    const ShapeTriangle& triangle = shape.triangles[i / 2];
    const Index cell = triangle.cells[i % 2];
    if (cell != None && shape.contains[cell])
    {
      return;
    }
    const Triangle balls = seenFrom(polarBalls.triangulation, triangle, i % 2);
    if (sharedSample(polarBalls, balls) != None)
    {
      return; // the singular point is that sample
    }
    const auto local = [&](int k) { return locator.balls()[balls[k]]; };
    const auto point = boundaryIntersection(local(0), local(1), local(2));
    const Index near = cell != None ? cell : triangle.cells[1 - i % 2];
    if (point && isOnUnion(locator, polarBalls.sides, *point, near))
    {
      found[i] = { triangle.balls, frame.toWorld(*point) };
    }
  });
  std::vector<Crossing> result;
  for (const auto& crossing : found)
  {
    if (crossing)
    {
      result.push_back(*crossing);
    }
  }
  return result;
}
}

SingularPoints singularPoints(
  const PolarBalls& polarBalls, const PowerShape& shape, const Execution& execution)
{
  const std::vector<std::vector<Index>> ballsOfSample = innerBallsOfSamples(polarBalls);
  SingularPoints result;
  const auto add = [&result](const Point& position, Index sample, const auto& balls) {
    result.positions.push_back(position);
    result.samples.push_back(sample);
    result.balls.items.insert(result.balls.items.end(), balls.begin(), balls.end());
    result.balls.close();
  };
  // In an order that doesn't depend on the order in which the samples were given.
  std::vector<Index> order;
  for (Index s = 0; s < count(ballsOfSample); ++s)
  {
    if (!ballsOfSample[s].empty())
    {
      order.push_back(s);
    }
  }
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const Point &p = polarBalls.samples[a], &q = polarBalls.samples[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  });
  for (const Index s : order)
  {
    add(polarBalls.samples[s], s, ballsOfSample[s]);
  }
  execution.report(0.1);
  const Frame frame = frameOf(polarBalls.samples);
  for (const Crossing& crossing : crossings(polarBalls, shape, frame, execution))
  {
    add(crossing.position, None, crossing.balls);
  }
  execution.report(1);
  return result;
}
}
