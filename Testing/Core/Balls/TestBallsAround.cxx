// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/BallsAround.h"

#include "Base/MoreNeighbors.h"
#include "Meshes.h"
#include "Samples/BoundarySamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace
{
using medial::BallsAround;
using medial::ClosedSurface;
using medial::Index;
using medial::Point;
using medial::PolarBalls;
using medial::Side;
using medial::SurfaceTree;

/// A ball by its samples, and its side.
using Named = std::pair<std::vector<Index>, Side>;

/// @param numbers  of the balls' samples among all
Named nameOf(Index ball, const PolarBalls& balls, const std::vector<Index>& numbers)
{
  Named result{ {}, balls.sides[ball] };
  for (const Index s : balls.ballSamples[ball])
  {
    result.first.push_back(numbers[s]);
  }
  return result;
}

/// The balls through the core.
std::set<Named> named(
  const PolarBalls& balls, const std::vector<Index>& numbers, const std::vector<Index>& core)
{
  std::set<Named> result;
  for (Index b = 0; b < medial::count(balls.balls); ++b)
  {
    const Named ball = nameOf(b, balls, numbers);
    if (std::any_of(ball.first.begin(), ball.first.end(),
          [&core](Index s) { return std::binary_search(core.begin(), core.end(), s); }))
    {
      result.insert(ball);
    }
  }
  return result;
}

/// Balls that are poles of the core's samples only, since others may lack theirs.
std::set<Named> polesOf(
  const PolarBalls& balls, const std::vector<Index>& numbers, const std::vector<Index>& core)
{
  std::set<Named> result;
  for (Index s = 0; s < medial::count(balls.samples); ++s)
  {
    if (std::binary_search(core.begin(), core.end(), numbers[s]))
    {
      for (const Index b : { balls.innerBall[s], balls.outerBall[s] })
      {
        if (b != medial::None)
        {
          result.insert(nameOf(b, balls, numbers));
        }
      }
    }
  }
  return result;
}

void expectAsAmongAll(const meshes::Mesh& mesh, double spacing)
{
  const ClosedSurface surface = medial::closedSurface(mesh.points, mesh.polygons);
  const SurfaceTree tree(surface.points, surface.triangles);
  medial::SamplingOptions options;
  options.spacing = spacing;
  const std::vector<Point> samples =
    medial::positions(medial::BoundarySampler(surface, tree, options).samples().points);
  const PolarBalls all = medial::polarBallsAndSamples(samples, {}, {}, &tree).balls;
  std::vector<Index> numbers(samples.size());
  for (Index s = 0; s < medial::count(samples); ++s)
  {
    numbers[s] = s;
  }
  const std::vector<Point> some(samples.begin(), samples.begin() + samples.size() / 2);
  const medial::Neighbors first(some);
  const medial::MoreNeighbors neighbors(first, samples);
  for (const Index start : { Index(0), medial::count(samples) / 2, medial::count(samples) - 1 })
  {
    SCOPED_TRACE(start);
    std::vector<Index> core = neighbors.within(samples[start], 4 * spacing);
    std::sort(core.begin(), core.end());
    // Knows of none of the balls, and of all.
    for (const PolarBalls& before : { PolarBalls(), all })
    {
      const BallsAround made = medial::ballsAround(core, before, samples, neighbors, tree);
      EXPECT_LT(made.samples.size(), samples.size());
      const std::set<Named> found = named(made.balls, made.samples, core);
      const std::set<Named> poles = polesOf(all, numbers, core);
      EXPECT_TRUE(std::includes(found.begin(), found.end(), poles.begin(), poles.end()));
      EXPECT_EQ(found.size(), made.balls.balls.size());
      EXPECT_FALSE(made.balls.triangulation.cells.empty());
    }
  }
}

TEST(BallsAround, AreThoseAmongAllSamples)
{
  expectAsAmongAll(meshes::torus(), 0.15);
  expectAsAmongAll(meshes::drilledPlate(0.3), 0.1);
  expectAsAmongAll(meshes::box(Point::Zero(), Point(3, 2, 1)), 0.1);
}
}
