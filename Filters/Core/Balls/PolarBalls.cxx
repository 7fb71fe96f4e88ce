// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/PolarBalls.h"

#include "Balls/Sides.h"
#include "Base/DisjointSets.h"
#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Predicates.h"
#include "Base/Triangulations.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace medial
{
namespace
{
/// The distinct samples in lexicographic order, so that results do not depend on the order given.
struct DistinctSamples
{
  Frame frame;
  std::vector<Point> points;      ///< local
  std::vector<Index> ids;         ///< lowest number of an equal sample in the input
  std::vector<Index> duplicateOf; ///< for each sample of the input
};

bool lexicographicallyLess(const Point& a, const Point& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

DistinctSamples distinctSamples(const std::vector<Point>& samples)
{
  DistinctSamples result;
  result.frame = frameOf(samples);
  std::vector<Point> local(samples.size());
  std::transform(samples.begin(), samples.end(), local.begin(),
    [&](const Point& p) -> Point { return result.frame.toLocal(p); });
  std::vector<Index> order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return local[a] == local[b] ? a < b : lexicographicallyLess(local[a], local[b]);
  });
  result.duplicateOf.assign(samples.size(), None);
  for (const Index i : order)
  {
    if (!result.points.empty() && result.points.back() == local[i])
    {
      result.duplicateOf[i] = result.ids.back();
      continue;
    }
    result.points.push_back(local[i]);
    result.ids.push_back(i);
  }
  return result;
}

/// @throw InvalidInput  no four samples span a volume, beyond the rounding of their coordinates
void requireVolume(const DistinctSamples& distinct)
{
  const std::vector<Point>& points = distinct.points;
  if (points.size() < 4)
  {
    throw InvalidInput("there are only ", points.size(),
      " distinct samples; at least 4 points of a closed surface are needed");
  }
  const auto farthest = [&points](const auto& distance) {
    return *std::max_element(points.begin(), points.end(),
      [&](const Point& p, const Point& q) { return distance(p) < distance(q); });
  };
  const Point a = points.front();
  const Point b = farthest([&](const Point& p) { return (p - a).norm(); });
  const Point direction = (b - a).normalized();
  const auto fromLine = [&](const Point& p) { return (p - a).cross(direction).norm(); };
  const Point c = farthest(fromLine);
  // Each coordinate is known to half a unit in the last place, given ones and local ones.
  const double rounding = 8 * std::numeric_limits<double>::epsilon() *
    (1 + distinct.frame.center.cwiseAbs().maxCoeff() * distinct.frame.scale);
  if (fromLine(c) <= rounding)
  {
    throw InvalidInput("all samples are on one line; points of a closed surface are needed");
  }
  const Point normal = (b - a).cross(c - a).normalized();
  const auto fromPlane = [&](const Point& p) { return std::abs((p - a).dot(normal)); };
  const double width = (b - a).norm() / fromLine(c); // how much a plane through them is tilted
  if (fromPlane(farthest(fromPlane)) <= rounding * std::max(1.0, width))
  {
    throw InvalidInput("all samples are in one plane; points of a closed surface are needed");
  }
}

/// Corners of a cube about the centre, so that every sample has an outer pole. Half its side is 2.5
/// times the diagonal of the samples' bounding box.
std::array<Point, 8> guards(const std::vector<Point>& points)
{
  const Eigen::AlignedBox3d box = boundingBox(points);
  const double half = 2.5 * box.diagonal().norm();
  std::array<Point, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = box.center() + half * Point(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  return corners;
}

/// The Delaunay triangulation of samples and guards; classes of cells with the same circumsphere.
struct Spheres
{
  std::vector<Point> points; ///< samples, then guards
  Index sampleCount;
  Tetrahedra delaunay;
  std::vector<double> cellVolumes;
  std::vector<Index> classOfCell; ///< lowest cell of the class
  std::vector<Ball> ballOfCell;   ///< the same for the whole class
};

/// All cells of a class take the sphere of its cell of largest volume, the best conditioned.
void shareBalls(Spheres& spheres)
{
  std::vector<Index> best(spheres.ballOfCell.size(), None);
  for (Index c = 0; c < count(best); ++c)
  {
    Index& chosen = best[spheres.classOfCell[c]];
    if (chosen == None || spheres.cellVolumes[c] > spheres.cellVolumes[chosen])
    {
      chosen = c;
    }
  }
  const std::vector<Ball> own = spheres.ballOfCell;
  for (Index c = 0; c < count(best); ++c)
  {
    spheres.ballOfCell[c] = own[best[spheres.classOfCell[c]]];
  }
}

Spheres delaunaySpheres(const std::vector<Point>& samples, const Execution& execution)
{
  Spheres result;
  result.points = samples;
  result.sampleCount = count(samples);
  for (const Point& guard : guards(samples))
  {
    result.points.push_back(guard);
  }
  result.delaunay = delaunay(result.points, execution);
  const Index cellCount = count(result.delaunay.cells);
  result.ballOfCell.resize(cellCount);
  result.cellVolumes.resize(cellCount);
  execution.forEach(cellCount, [&](Index c) {
    const Tetrahedron& v = result.delaunay.cells[c];
    const std::vector<Point>& p = result.points;
    const std::array<Point, 4> corners{ p[v[0]], p[v[1]], p[v[2]], p[v[3]] };
    result.ballOfCell[c] = circumsphere(corners, constructionError);
    result.cellVolumes[c] =
      std::abs(
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0])) /
      6;
  });
  DisjointSets classes(cellCount);
  for (Index c = 0; c < cellCount; ++c)
  {
    for (const Index n : result.delaunay.neighbors[c])
    {
      if (n > c && (result.ballOfCell[c].center - result.ballOfCell[n].center).norm() < coincident)
      {
        classes.unite(c, n);
      }
    }
  }
  result.classOfCell.resize(cellCount);
  for (Index c = 0; c < cellCount; ++c)
  {
    result.classOfCell[c] = classes.find(c);
  }
  shareBalls(result);
  return result;
}

/// The classes of the two poles of each sample, as their lowest cells, or None.
std::vector<std::array<Index, 2>> poles(const Spheres& spheres)
{
  std::vector<std::array<Index, 2>> result(spheres.sampleCount, { None, None });
  // Every sphere passes through its sample, so the farthest centre has the largest radius.
  const auto offer = [&spheres](Index& pole, Index c) {
    const Index candidate = spheres.classOfCell[c];
    if (pole == None || spheres.ballOfCell[candidate].radius > spheres.ballOfCell[pole].radius ||
      (spheres.ballOfCell[candidate].radius == spheres.ballOfCell[pole].radius && candidate < pole))
    {
      pole = candidate;
    }
  };
  for (int second = 0; second < 2; ++second)
  {
    for (Index c = 0; c < count(spheres.delaunay.cells); ++c)
    {
      for (const Index s : spheres.delaunay.cells[c])
      {
        if (s >= spheres.sampleCount)
        {
          continue;
        }
        const Point& sample = spheres.points[s];
        if (second == 0 ||
          (spheres.ballOfCell[c].center - sample)
              .dot(spheres.ballOfCell[result[s][0]].center - sample) < 0)
        {
          offer(result[s][second], c);
        }
      }
    }
  }
  return result;
}

/// Gives every class that is a pole the number of a ball; returns it for each cell, or None.
std::vector<Index> numberBalls(
  const Spheres& spheres, const std::vector<std::array<Index, 2>>& poles, PolarBalls& result)
{
  std::vector<char> isPole(spheres.classOfCell.size(), 0);
  for (const auto& pair : poles)
  {
    for (const Index pole : pair)
    {
      if (pole != None)
      {
        isPole[pole] = 1;
      }
    }
  }
  std::vector<Index> ballOfCell(isPole.size(), None);
  for (Index c = 0; c < count(isPole); ++c)
  {
    const Index first = spheres.classOfCell[c];
    if (c == first && isPole[c])
    {
      ballOfCell[c] = count(result.balls);
      result.balls.push_back(spheres.ballOfCell[c]);
    }
    ballOfCell[c] = ballOfCell[first];
  }
  return ballOfCell;
}

/// Fills ballSamples (ids of the input) and touchesGuard.
void collectSamples(const Spheres& spheres, const std::vector<Index>& ballOfCell,
  const std::vector<Index>& ids, PolarBalls& result)
{
  std::vector<std::vector<Index>> samples(result.balls.size());
  result.touchesGuard.assign(result.balls.size(), 0);
  for (Index c = 0; c < count(ballOfCell); ++c)
  {
    if (ballOfCell[c] == None)
    {
      continue;
    }
    for (const Index v : spheres.delaunay.cells[c])
    {
      if (v < spheres.sampleCount)
      {
        samples[ballOfCell[c]].push_back(ids[v]);
      }
      else
      {
        result.touchesGuard[ballOfCell[c]] = 1;
      }
    }
  }
  for (std::vector<Index>& list : samples)
  {
    sortUnique(list);
    result.ballSamples.append(list);
  }
}

/// Adds the volume of every inner Delaunay cell to one inner ball: its own, else of the balls of its
/// samples the one with the least power at its centroid (no volume where that is outside). Its own is
/// a pole's.
void measureVolumes(const Spheres& spheres, const std::vector<Index>& ballOfCell,
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

std::vector<Tetrahedron> powerCells(const std::vector<Ball>& balls, const Execution& execution)
{
  std::vector<Ball> weighted;
  for (Index b = 0; b < count(balls); ++b)
  {
    weighted.push_back(jittered(balls[b], b));
  }
  RegularTriangulation triangulation;
  triangulation.insert(weighted, execution);
  return triangulation.tetrahedra().cells;
}

/// Fills the arrays with one entry for each sample.
void describeSamples(const DistinctSamples& distinct,
  const std::vector<std::array<Index, 2>>& ballsOfSample, PolarBalls& result)
{
  const std::size_t n = distinct.duplicateOf.size();
  result.duplicateOf = distinct.duplicateOf;
  result.innerBall.assign(n, None);
  result.outerBall.assign(n, None);
  result.samplingQuality.assign(n, 0);
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
    const auto [first, second] = ballsOfSample[s];
    if (first != None && second != None)
    {
      const Point u = result.balls[first].center - distinct.points[s];
      const Point v = result.balls[second].center - distinct.points[s];
      result.samplingQuality[id] = -u.normalized().dot(v.normalized());
    }
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const Index first = result.duplicateOf[i];
    if (first != None)
    {
      result.innerBall[i] = result.innerBall[first];
      result.outerBall[i] = result.outerBall[first];
      result.samplingQuality[i] = result.samplingQuality[first];
    }
  }
}

/// Mean length of the shortest edge at a sample: its nearest neighbour is a Delaunay neighbour. Samples
/// that are the same to rounding don't count.
double meanSpacing(const Spheres& spheres)
{
  std::vector<double> shortest(spheres.sampleCount, std::numeric_limits<double>::infinity());
  for (const Tetrahedron& cell : spheres.delaunay.cells)
  {
    for (const auto& [i, j] : cellEdges)
    {
      const Index a = cell[i], b = cell[j];
      if (a < spheres.sampleCount && b < spheres.sampleCount)
      {
        const double length = (spheres.points[a] - spheres.points[b]).norm();
        shortest[a] = length < coincident ? shortest[a] : std::min(shortest[a], length);
        shortest[b] = length < coincident ? shortest[b] : std::min(shortest[b], length);
      }
    }
  }
  double sum = 0;
  Index finite = 0;
  for (const double length : shortest)
  {
    if (std::isfinite(length))
    {
      sum += length;
      ++finite;
    }
  }
  return finite > 0 ? sum / finite : 0;
}
}

PolarBalls polarBalls(const std::vector<Point>& samples, const Execution& execution)
{
  const DistinctSamples distinct = distinctSamples(samples);
  requireVolume(distinct);
  const Spheres spheres = delaunaySpheres(distinct.points, execution.part(0, 0.2));
  const std::vector<std::array<Index, 2>> poleClasses = poles(spheres);
  PolarBalls result;
  result.samples = samples;
  const std::vector<Index> ballOfCell = numberBalls(spheres, poleClasses, result);
  collectSamples(spheres, ballOfCell, distinct.ids, result);
  result.cells = powerCells(result.balls, execution.part(0.2, 0.8));

  std::vector<std::array<Index, 2>> ballsOfSample(poleClasses.size());
  for (std::size_t s = 0; s < poleClasses.size(); ++s)
  {
    for (int k = 0; k < 2; ++k)
    {
      ballsOfSample[s][k] = poleClasses[s][k] == None ? None : ballOfCell[poleClasses[s][k]];
    }
  }
  result.sides =
    sides({ distinct.points, ballsOfSample, result.balls, result.touchesGuard, result.cells },
      execution.part(0.8, 0.9));
  measureVolumes(spheres, ballOfCell, ballsOfSample, result, execution);
  describeSamples(distinct, ballsOfSample, result);

  const double unit = 1 / distinct.frame.scale;
  result.spacing = meanSpacing(spheres) * unit;
  std::transform(result.balls.begin(), result.balls.end(), result.balls.begin(),
    [&](const Ball& ball) { return distinct.frame.toWorld(ball); });
  for (std::vector<double>* volumes : { &result.volumes, &result.poleVolumes })
  {
    for (double& volume : *volumes)
    {
      volume *= unit * unit * unit;
    }
  }
  execution.report(1);
  return result;
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
