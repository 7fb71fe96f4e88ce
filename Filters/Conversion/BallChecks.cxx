// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/BallChecks.h"

#include "Balls/DelaunaySpheres.h"
#include "Base/Errors.h"
#include "Base/Frame.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Remedies.h"

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{
/// Balls differ from where they were made by less than this share of the size of what they lie in: then
/// they have at most been through a file of floats. Balls of another object differ by far more.
constexpr double moved = 1e-6;

void checkPlaces(const PolarBalls& balls, const Frame& frame)
{
  constexpr double farthest = 1e75; // in units of the samples' box: fourth powers are numbers
  for (Index b = 0; b < count(balls.balls); ++b)
  {
    const Ball ball = frame.toLocal(balls.balls[b]);
    if (!(std::max(ball.center.cwiseAbs().maxCoeff(), ball.radius) < farthest))
    {
      throw InvalidInput("ball ", b, " is more than ", farthest,
        " times as far away or as large as the samples' bounding box: ", TakePolarBalls);
    }
    if (!(ball.radius > 0))
    {
      throw InvalidInput("the point array '", names::Radius, "' has the value ",
        balls.balls[b].radius, " at ", b, "; only positive numbers can be there: ", TakePolarBalls);
    }
  }
}

void checkSides(const PolarBalls& balls)
{
  std::vector<char> isCorner(balls.balls.size(), 0);
  for (const Tetrahedron& cell : balls.triangulation.cells)
  {
    for (const Index ball : cell)
    {
      isCorner[ball] = 1;
    }
  }
  for (Index b = 0; b < count(balls.balls); ++b)
  {
    if (isCorner[b] != (balls.sides[b] != Side::Hidden))
    {
      throw InvalidInput("ball ", b, " is a corner of ", isCorner[b] ? "a" : "no",
        " tetrahedron, but the point array '", names::Side, "' says ",
        static_cast<int>(balls.sides[b]), isCorner[b] ? " (hidden)" : " (not hidden)", ": ",
        TakePolarBalls);
    }
    if (balls.sides[b] == Side::Inner && balls.touchesGuard[b])
    {
      throw InvalidInput("ball ", b, " is inside by the point array '", names::Side,
        "', but the point array '", names::TouchesGuard,
        "' says that it is outside: ", TakePolarBalls);
    }
  }
}

void checkVolumes(const PolarBalls& balls)
{
  double sum = 0;
  for (Index b = 0; b < count(balls.balls); ++b)
  {
    const double volume = balls.volumes[b];
    if (balls.poleVolumes[b] > volume || (volume > 0 && balls.sides[b] != Side::Inner))
    {
      throw InvalidInput("the point array '", names::Volume, "' has the value ", volume, " at ", b,
        "; it is at least the ball's '", names::PoleVolume, "', ", balls.poleVolumes[b],
        ", and 0 where the ball isn't inside: ", TakePolarBalls);
    }
    sum += volume;
  }
  if (!std::isfinite(sum))
  {
    throw InvalidInput(
      "the sum of the point array '", names::Volume, "' is no number any more: ", TakePolarBalls);
  }
}

/// How far a centre may be from where it was made. Far from the origin doubles themselves are coarse.
double movedIn(const std::vector<Point>& samples)
{
  // The centre, the sample and their difference are rounded, in three coordinates.
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const Eigen::AlignedBox3d box = boundingBox(samples);
  const double largest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  return moved * box.diagonal().norm() + rounding * largest;
}

void checkSamplesOnBalls(const PolarBalls& balls, double movedHere)
{
  const double precision = leastPrecision * balls.spacing; // of samples: they may be off so much
  for (Index b = 0; b < count(balls.balls); ++b)
  {
    const Ball& ball = balls.balls[b];
    if (balls.ballSamples[b].size() == 0)
    {
      throw InvalidInput("ball ", b, " has no sample in the field array '", names::BallSamples,
        "': ", TakePolarBalls);
    }
    for (const Index sample : balls.ballSamples[b])
    {
      const double distance = (balls.samples[sample] - ball.center).norm();
      if (!(std::abs(distance - ball.radius) <= precision + movedHere + moved * ball.radius))
      {
        throw InvalidInput("sample ", sample, " isn't on ball ", b, " of radius ", ball.radius,
          " but ", distance, " from its centre, though the field array '", names::BallSamples,
          "' says so: ", TakePolarBalls);
      }
    }
  }
}

void checkNormals(const std::vector<Point>& normals)
{
  for (Index s = 0; s < count(normals); ++s)
  {
    if (!normals[s].isZero() && !(std::abs(normals[s].norm() - 1) <= moved))
    {
      throw InvalidInput("the field array '", names::SampleNormals, "' has a normal of length ",
        normals[s].norm(), " at ", s,
        "; its length is 1, or 0 where it isn't known: ", TakePolarBalls);
    }
  }
}

/// Has each sample an inner ball that is inside, and an outer one that is outside?
void checkBallsOfSamples(
  const PolarBalls& balls, const std::vector<Index>& ballOfSample, Side side, const char* name)
{
  for (Index s = 0; s < count(ballOfSample); ++s)
  {
    const Index ball = ballOfSample[s];
    if (ball != None && balls.sides[ball] != side)
    {
      throw InvalidInput("the field array '", name, "' has the ball ", ball, " at ", s,
        ", which the point array '", names::Side, "' puts on another side: ", TakePolarBalls);
    }
  }
}
}

void checkBalls(PolarBalls& balls, CellNeighbors neighbors)
{
  const Frame frame = frameOf(balls.samples);
  const double size = boundingBox(balls.samples).diagonal().norm();
  checkPlaces(balls, frame);
  checkSides(balls);
  checkVolumes(balls);
  const double movedHere = movedIn(balls.samples);
  checkSamplesOnBalls(balls, movedHere);
  checkNormals(balls.normals);
  checkBallsOfSamples(balls, balls.innerBall, Side::Inner, names::SampleInnerBall);
  checkBallsOfSamples(balls, balls.outerBall, Side::Outer, names::SampleOuterBall);
  // Distances below `coincident` don't count for it. Far smaller ones would have the crust refined for ever.
  if (!(balls.spacing * frame.scale >= coincident && balls.spacing <= size))
  {
    throw InvalidInput("the field array '", names::SampleSpacing, "' has the value ", balls.spacing,
      "; only numbers from ", coincident / frame.scale, " to ", size,
      ", the diagonal of the samples' bounding box, can be there: ", TakePolarBalls);
  }
  checkTetrahedra(balls, movedHere, moved, neighbors);
}
}
