// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/Centerlines.h"

#include "Base/BallTree.h"
#include "Base/Errors.h"
#include "Measuring/BurnTimes.h"
#include "Measuring/CurveBranches.h"
#include "Measuring/CurveForks.h"
#include "Measuring/CurveRadii.h"
#include "Measuring/CurveSkeleton.h"
#include "Measuring/CurveSmoothing.h"
#include "Measuring/RodPieces.h"
#include "Measuring/Twigs.h"

#include <algorithm>
#include <array>
#include <utility>

namespace medial
{
namespace
{
void check(const MedialAxis& axis, const CenterlineOptions& options)
{
  if (!(options.widthRatio >= 0))
  {
    throw InvalidInput("The width ratio of rods is ", options.widthRatio,
      "; give a number above 1, or 0 for curves through plates, too.");
  }
  if (axis.erosion.size() != axis.points.size() || count(axis.cellErosion) != axis.cells.size())
  {
    throw InvalidInput(
      "The medial axis has no erosion thickness for each of its points, which tells how wide "
      "it is. Make it with medialAxis().");
  }
}

/// Smoothed curves that meet at nodes, which are points of the axis.
std::vector<Centerline> wholeCurves(const MedialAxis& axis, const std::vector<double>& times,
  const std::vector<Edge>& edges, const Execution& execution)
{
  const std::vector<CurveBranch> branches = curveBranches(axis, times, edges);
  std::vector<Centerline> result(branches.size());
  execution.forEach(
    count(branches), [&](Index i) { result[i] = smoothed(axis, times, branches[i]); });
  const BallTree solid(maximalBalls(axis));
  joinAtForks(axis, solid, result);
  bindRadii(axis, solid, result, execution.between(0.5, 1));
  return result;
}

std::vector<Centerline> cutAtPlates(
  const std::vector<Centerline>& curves, Index pointCount, double widthRatio)
{
  std::vector<Index> degree(pointCount, 0);
  for (const Centerline& curve : curves)
  {
    for (const Index node : curve.nodes)
    {
      degree[std::max(node, 0)] += node != None ? 1 : 0;
    }
  }
  std::vector<Centerline> result;
  for (const Centerline& curve : curves)
  {
    const auto isFree = [&](Index node) { return node != None && degree[node] == 1; };
    for (Centerline& piece :
      rodPieces(curve, { isFree(curve.nodes[0]), isFree(curve.nodes[1]) }, widthRatio))
    {
      result.push_back(std::move(piece));
    }
  }
  return result;
}

/// Numbers the nodes in the order of the branches. A loop that meets nothing has none.
Centerlines numbered(std::vector<Centerline> curves, Index pointCount)
{
  Centerlines result{ std::move(curves), {}, 0 };
  std::vector<Index> numberOf(pointCount, None);
  for (Centerline& branch : result.branches)
  {
    for (const bool isLast : { false, true })
    {
      Index& node = branch.nodes[isLast];
      if (node == None)
      {
        continue;
      }
      const bool isAtPlate = node == AtPlate;
      const Index known = isAtPlate ? None : numberOf[node];
      const Index number = known == None ? count(result.nodes) : known;
      const double radius = isLast ? branch.radii.back() : branch.radii.front();
      if (known == None)
      {
        const Point& place = isLast ? branch.points.back() : branch.points.front();
        result.nodes.push_back({ place, radius, 0, isAtPlate });
      }
      if (!isAtPlate)
      {
        numberOf[node] = number;
      }
      node = number;
      CenterlineNode& here = result.nodes[number];
      ++here.degree;
      here.radius += (radius - here.radius) / here.degree; // the mean
    }
  }
  for (Centerline& branch : result.branches)
  {
    if (branch.nodes[0] != None)
    {
      branch.radii.front() = result.nodes[branch.nodes[0]].radius;
      branch.radii.back() = result.nodes[branch.nodes[1]].radius;
    }
  }
  return result;
}
}

Centerlines centerlines(
  const MedialAxis& axis, const CenterlineOptions& options, const Execution& execution)
{
  check(axis, options);
  const std::vector<double> times = burnTimes(axis);
  const CurveSkeleton skeleton = curveSkeleton(axis, axisEdges(axis.cells), times,
    std::vector<char>(axis.cells.triangles.size(), 1), execution.between(0, 0.5));
  const std::vector<Edge> edges =
    withoutTwigs(axis, times, skeleton.edges, execution.between(0.5, 0.6));
  std::vector<Centerline> curves = wholeCurves(axis, times, edges, execution.between(0.6, 1));
  if (options.widthRatio > 0)
  {
    curves = cutAtPlates(curves, count(axis.points), options.widthRatio);
  }
  Centerlines result = numbered(std::move(curves), count(axis.points));
  result.openedVoids = skeleton.openedVoids;
  execution.report(1);
  return result;
}
}
