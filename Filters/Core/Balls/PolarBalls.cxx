// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/PolarBalls.h"

#include "Balls/CrowdedPoles.h"
#include "Balls/DelaunaySpheres.h"
#include "Balls/DistinctSamples.h"
#include "Balls/MarkedBetti.h"
#include "Balls/NormalVotes.h"
#include "Balls/Poles.h"
#include "Balls/SampleDoubts.h"
#include "Balls/Sides.h"
#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Tetrahedra.h"
#include "Base/Triangulations.h"

#include <algorithm>
#include <limits>

// Steps: Delaunay triangulation of samples and guards; the poles of each sample; a ball for each class
// of cells that is somebody's pole, but one for those that crowd; the balls' regular triangulation; their sides; their volumes.
// Samples are numbered in lexicographic order here, and by `ids` as in the input where they leave. All
// lengths are in the frame until the end. n samples have at most 2n balls, but more where the samples are
// regular; all steps take O(n log n) time in practice; the two triangulations take most of it.
namespace medial
{
namespace
{
/// Makes a ball of every pole that stands for itself.
/// @param standing  see standingPoles()
/// @return  for each cell the ball that stands for its class, or None
std::vector<Index> numberBalls(
  const DelaunaySpheres& spheres, const std::vector<Index>& standing, PolarBalls& result)
{
  std::vector<Index> ballOfPole(standing.size(), None);
  for (Index c = 0; c < count(standing); ++c)
  {
    if (standing[c] == c)
    {
      ballOfPole[c] = count(result.balls);
      result.balls.push_back(spheres.ballOfCell[c]);
    }
  }
  std::vector<Index> ballOfCell(standing.size());
  std::transform(spheres.classOfCell.begin(), spheres.classOfCell.end(), ballOfCell.begin(),
    [&](Index c) { return standing[c] == None ? None : ballOfPole[standing[c]]; });
  return ballOfCell;
}

/// Fills ballSamples, with numbers of the input, and touchesGuard.
void collectSamples(const DelaunaySpheres& spheres, const std::vector<Index>& standing,
  const std::vector<Index>& ballOfCell, const std::vector<Index>& ids, PolarBalls& result)
{
  result.touchesGuard.assign(result.balls.size(), 0);
  const IndexLists cells = listsByKey(count(result.balls), [&](const auto& add) {
    for (Index c = 0; c < count(ballOfCell); ++c)
    {
      const Index itsClass = spheres.classOfCell[c];
      if (ballOfCell[c] != None && standing[itsClass] == itsClass)
      {
        add(ballOfCell[c], c);
      }
    }
  });
  std::vector<Index> own;
  for (Index b = 0; b < count(result.balls); ++b)
  {
    own.clear();
    for (const Index c : cells[b])
    {
      for (const Index v : spheres.delaunay.cells[c])
      {
        if (v < spheres.sampleCount)
        {
          own.push_back(ids[v]);
        }
        else
        {
          result.touchesGuard[b] = 1;
        }
      }
    }
    sortUnique(own);
    result.ballSamples.append(own);
  }
}

/// Shares the volume of the solid out among the inner balls: each Delaunay cell counts for one ball.
/// That is the ball of its own class. A class that is nobody's pole has none; its cells count for that
/// ball of its samples that has the least power at the cell's centroid. A cell whose ball is not inner
/// is outside the solid and counts for nothing.
void measureVolumes(const DelaunaySpheres& spheres, const std::vector<Index>& ballOfCell,
  const std::vector<std::array<Index, 2>>& ballsOfSample, PolarBalls& result,
  const Execution& execution)
{
  std::vector<Index> nearest(ballOfCell);
  execution.forEach(count(nearest), [&](Index c) {
    if (nearest[c] != None)
    {
      return;
    }
    Point centroid = Point::Zero();
    for (const Index v : spheres.delaunay.cells[c])
    {
      centroid += 0.25 * spheres.points[v];
    }
    double least = std::numeric_limits<double>::infinity();
    for (const Index v : spheres.delaunay.cells[c])
    {
      for (const Index b :
        v < spheres.sampleCount ? ballsOfSample[v] : std::array<Index, 2>{ None, None })
      {
        const double power = b == None ? least
                                       : (result.balls[b].center - centroid).squaredNorm() -
            result.balls[b].radius * result.balls[b].radius;
        if (power < least)
        {
          least = power;
          nearest[c] = b;
        }
      }
    }
  });
  result.volumes.assign(result.balls.size(), 0);
  result.poleVolumes.assign(result.balls.size(), 0);
  for (Index c = 0; c < count(nearest); ++c)
  {
    if (nearest[c] != None && result.sides[nearest[c]] == Side::Inner)
    {
      result.volumes[nearest[c]] += spheres.cellVolumes[c];
      result.poleVolumes[nearest[c]] += nearest[c] == ballOfCell[c] ? spheres.cellVolumes[c] : 0;
    }
  }
}

/// Fills innerBall and outerBall. A sample that counts as another one has that one's balls.
void assignBalls(const DistinctSamples& distinct,
  const std::vector<std::array<Index, 2>>& ballsOfSample, PolarBalls& result)
{
  const std::size_t n = distinct.duplicateOf.size();
  result.innerBall.assign(n, None);
  result.outerBall.assign(n, None);
  for (Index s = 0; s < count(ballsOfSample); ++s)
  {
    const Index id = distinct.ids[s];
    for (const Index ball : ballsOfSample[s])
    {
      const Side side = ball == None ? Side::Hidden : result.sides[ball];
      Index& place = side == Side::Inner ? result.innerBall[id] : result.outerBall[id];
      if (side != Side::Hidden && place == None)
      {
        place = ball;
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const Index first = distinct.duplicateOf[i];
    if (first != None)
    {
      result.innerBall[i] = result.innerBall[first];
      result.outerBall[i] = result.outerBall[first];
    }
  }
}

/// @param balls  in the frame
SampleDescription describeSamples(const DistinctSamples& distinct,
  const std::vector<std::array<Index, 2>>& ballsOfSample, const std::vector<Ball>& balls)
{
  SampleDescription result;
  result.duplicateOf = distinct.duplicateOf;
  result.quality.assign(result.duplicateOf.size(), 0);
  for (Index s = 0; s < count(ballsOfSample); ++s)
  {
    const auto [first, second] = ballsOfSample[s];
    if (first != None && second != None)
    {
      result.quality[distinct.ids[s]] = opposition(distinct.points[s], balls[first], balls[second]);
    }
  }
  for (std::size_t i = 0; i < result.quality.size(); ++i)
  {
    const Index first = result.duplicateOf[i];
    result.quality[i] = result.quality[first == None ? i : first];
  }
  return result;
}

struct DecidedSides
{
  std::vector<Side> ofBall;
  std::vector<Point> normals; ///< of the samples; empty where there are none that are of use
  Warnings warnings;          ///< about normals
};

/// The sides by the samples' normals, or without.
DecidedSides decidedSides(const SideInput& input, const std::vector<Point>& normals,
  const DistinctSamples& distinct, const IndexLists& ballSamples, const Execution& execution)
{
  if (normals.empty())
  {
    return { sides(input, execution), {}, {} };
  }
  const NormalVotes votes = normalVotes(normals, distinct, ballSamples, input);
  DecidedSides result{ sides(input, execution, votes.ofBall), {}, votes.warnings };
  if (!votes.ofBall.empty())
  {
    result.normals = votes.normals;
  }
  const Warnings more = normalWarnings(votes, distinct, input, result.ofBall);
  result.warnings.insert(result.warnings.end(), more.begin(), more.end());
  return result;
}

/// For each sample its two balls, or None.
std::vector<std::array<Index, 2>> ballsOfPoles(
  const std::vector<std::array<Index, 2>>& poles, const std::vector<Index>& ballOfCell)
{
  const auto ballOf = [&](Index pole) { return pole == None ? None : ballOfCell[pole]; };
  std::vector<std::array<Index, 2>> result(poles.size());
  std::transform(poles.begin(), poles.end(), result.begin(), [&](const std::array<Index, 2>& pair) {
    return std::array{ ballOf(pair[0]), ballOf(pair[1]) };
  });
  return result;
}

/// Lengths and volumes from the frame to the unit of the samples.
void toWorld(const Frame& frame, PolarBalls& balls)
{
  const double unit = 1 / frame.scale;
  balls.spacing *= unit;
  std::transform(balls.balls.begin(), balls.balls.end(), balls.balls.begin(),
    [&](const Ball& ball) { return frame.toWorld(ball); });
  for (std::vector<double>* volumes : { &balls.volumes, &balls.poleVolumes })
  {
    for (double& volume : *volumes)
    {
      volume *= unit * unit * unit;
    }
  }
}
}

Tetrahedra powerCells(const std::vector<Ball>& balls, const Execution& execution)
{
  std::vector<Ball> weighted;
  weighted.reserve(balls.size());
  for (Index b = 0; b < count(balls); ++b)
  {
    weighted.push_back(jittered(balls[b], b));
  }
  RegularTriangulation triangulation;
  triangulation.insert(weighted, execution);
  return triangulation.tetrahedra();
}

PolarBalls ballsWithoutSides(const std::vector<Point>& samples, const Execution& execution)
{
  const DistinctSamples distinct = distinctSamples(samples, { -1, 0, false });
  const DelaunaySpheres spheres =
    delaunaySpheres(distinct.points, distinct.precision * distinct.frame.scale, execution);
  const std::vector<Index> standing = polesAlone(poles(spheres)); // all samples decide which crowd
  PolarBalls result;
  result.samples = samples;
  collectSamples(spheres, standing, numberBalls(spheres, standing, result), distinct.ids, result);
  toWorld(distinct.frame, result);
  return result;
}

PolarBallsAndSamples polarBallsAndSamples(const std::vector<Point>& samples,
  const MergeOptions& options, const Execution& execution, const SurfaceTree* solid,
  const std::vector<Point>& normals)
{
  const DistinctSamples distinct =
    distinctSamples(samples, { options.tolerance, options.unit, options.clusters && !solid });
  requireVolume(samples, distinct);
  const DelaunaySpheres spheres = delaunaySpheres(
    distinct.points, distinct.precision * distinct.frame.scale, execution.between(0, 0.2));
  const Poles polesOfSamples = poles(spheres);
  PolarBallsAndSamples made;
  PolarBalls& result = made.balls;
  result.samples = samples;
  const std::vector<Index> standing = standingPoles(spheres, polesOfSamples);
  const std::vector<Index> ballOfCell = numberBalls(spheres, standing, result);
  collectSamples(spheres, standing, ballOfCell, distinct.ids, result);
  result.triangulation = powerCells(result.balls, execution.between(0.2, 0.8));
  const Tetrahedra& mesh = result.triangulation;
  const std::vector<Edge> edges = edgeNumbers(mesh.cells, count(result.balls)).edges;

  const std::vector<std::array<Index, 2>> ballsOfSample =
    ballsOfPoles(polesOfSamples.ofSample, ballOfCell);
  const SideInput evidence{ distinct.points, ballsOfSample, result.balls, result.touchesGuard,
    edges };
  const Execution labelling = execution.between(0.8, 0.9);
  const DecidedSides decided = solid
    ? DecidedSides{ sidesIn(*solid, distinct.frame, evidence, labelling),
        distinctNormals(normals, distinct), {} }
    : decidedSides(evidence, normals, distinct, result.ballSamples, labelling);
  result.sides = decided.ofBall;
  result.normals = decided.normals;
  measureVolumes(spheres, ballOfCell, ballsOfSample, result, execution);
  assignBalls(distinct, ballsOfSample, result);
  made.samples = describeSamples(distinct, ballsOfSample, result.balls);
  result.spacing = spheres.meanSpacing;
  made.powerShape = markedBetti(mesh, edges, innerBalls(result.sides));
  if (!solid) // else the solid tells whether the result is right
  {
    made.samples.warnings =
      sampleDoubts({ samples, distinct, ballsOfSample, result.balls, result.sides,
                     result.ballSamples, mesh, edges, made.powerShape },
        execution.between(0.9, 1));
    made.samples.warnings.insert(
      made.samples.warnings.end(), decided.warnings.begin(), decided.warnings.end());
  }
  toWorld(distinct.frame, result);
  made.samples.mergeTolerance = distinct.tolerance;
  execution.report(1);
  return made;
}

PolarBalls polarBalls(const std::vector<Point>& samples, const Execution& execution)
{
  return polarBallsAndSamples(samples, {}, execution).balls;
}

std::vector<std::vector<Index>> innerBallsOfSamples(const PolarBalls& polarBalls)
{
  std::vector<std::vector<Index>> result(polarBalls.samples.size());
  for (Index b = 0; b < count(polarBalls.balls); ++b)
  {
    if (polarBalls.sides[b] == Side::Inner)
    {
      for (const Index s : polarBalls.ballSamples[b])
      {
        result[s].push_back(b);
      }
    }
  }
  return result;
}
}
