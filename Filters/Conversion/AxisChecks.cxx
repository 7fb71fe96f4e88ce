// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/AxisChecks.h"

#include "Axis/AxisBetti.h"
#include "Axis/AxisEdges.h"
#include "Base/Errors.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Remedies.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{
/// Areas, their squares, and moments of areas are numbers up to this length.
constexpr double longest = 1e70;

void checkLengths(const std::vector<double>& lengths, const char* name)
{
  const auto wrong = std::find_if(
    lengths.begin(), lengths.end(), [](double length) { return !(length <= longest); });
  if (wrong != lengths.end())
  {
    throw InvalidInput("the array '", name, "' of the axis has the value ", *wrong, " at ",
      wrong - lengths.begin(), "; at most ", longest,
      " can be there, so that squares of areas are numbers: use another unit of length, or ",
      TakeMedialAxis);
  }
}

void checkPlaces(const MedialAxis& axis)
{
  for (Index p = 0; p < count(axis.points); ++p)
  {
    if (!(axis.points[p].cwiseAbs().maxCoeff() <= longest))
    {
      throw InvalidInput("point ", p, " of the axis has a coordinate above ", longest,
        ", so that squares of areas are no numbers: use another unit of length, or ",
        TakeMedialAxis);
    }
  }
  checkLengths(axis.radii, names::Radius);
  checkLengths(axis.erosion, names::ErosionThickness);
  checkLengths(axis.cellErosion, names::ErosionThickness);
  for (Index cell = 0; cell < axis.cells.size(); ++cell)
  {
    constexpr double halfTurn = 180.000001; // rounded
    const SiteView& view = axis.siteViews[cell];
    if (!(view.objectAngle <= halfTurn && view.lambda <= longest))
    {
      throw InvalidInput("cell ", cell, " of the axis sees its sites at an angle of ",
        view.objectAngle, " degrees (the cell array '", names::ObjectAngle, "') at a distance of ",
        view.lambda, " ('", names::Lambda, "'), which can't be: ", TakeMedialAxis);
    }
  }
}

void checkOwners(const MedialAxis& axis)
{
  std::vector<char> isOnAxis(axis.ballOwner.size(), 0);
  for (Index p = 0; p < count(axis.points); ++p)
  {
    if (axis.ballOfPoint[p] != None)
    {
      isOnAxis[axis.ballOfPoint[p]] = 1;
    }
  }
  for (Index b = 0; b < count(axis.ballOwner); ++b)
  {
    const Index owner = axis.ballOwner[b];
    if ((owner == b) != (isOnAxis[b] != 0))
    {
      throw InvalidInput("ball ", b, isOnAxis[b] ? " is" : " isn't", " in the point array '",
        names::BallId, "', but its entry in the field array '", names::BallOwner, "' is ", owner,
        ": a ball owns itself where it is on the axis: ", TakeMedialAxis);
    }
    if (owner != None && axis.ballOwner[owner] != owner)
    {
      throw InvalidInput("the field array '", names::BallOwner, "' has the value ", owner, " at ",
        b, ", a ball that doesn't own itself: ", TakeMedialAxis);
    }
  }
}

void checkVolumes(const MedialAxis& axis)
{
  double sum = 0;
  for (Index b = 0; b < count(axis.ballVolumes); ++b)
  {
    if (axis.poleVolumes[b] > axis.ballVolumes[b])
    {
      throw InvalidInput("the field array '", names::BallPoleVolume, "' has the value ",
        axis.poleVolumes[b], " at ", b, ", which is more than the ball's '", names::BallVolume,
        "', ", axis.ballVolumes[b], ": ", TakeMedialAxis);
    }
    sum += axis.ballVolumes[b];
  }
  if (!std::isfinite(sum))
  {
    throw InvalidInput("the sum of the field array '", names::BallVolume,
      "' is no number any more: ", TakeMedialAxis);
  }
}

/// Do two of the triangles at an edge have the same third corner?
/// @param thirds  filled with the third corners
bool hasTwins(
  const AxisCells& cells, const Edge& edge, IndexLists::View triangles, std::vector<Index>& thirds)
{
  thirds.clear();
  for (const Index t : triangles)
  {
    const Triangle& corners = cells.triangles[t];
    thirds.push_back(corners[0] ^ corners[1] ^ corners[2] ^ edge[0] ^ edge[1]); // what is left
  }
  std::sort(thirds.begin(), thirds.end());
  return std::adjacent_find(thirds.begin(), thirds.end()) != thirds.end();
}

/// No cell is there twice, and vertices and edges are in no higher cell: parts hold each of their points
/// and edges through one kind of cell.
void checkCells(const AxisCells& cells, Index pointCount)
{
  const AxisEdges edges = axisEdges(cells);
  std::vector<Index> thirds;
  for (Index e = 0; e < count(edges.points); ++e)
  {
    const Edge& ends = edges.points[e];
    if (hasTwins(cells, ends, edges.triangles[e], thirds))
    {
      throw InvalidInput("the axis has a triangle with the points ", ends[0], " and ", ends[1],
        " twice: ", TakeMedialAxis);
    }
  }
  std::vector<char> isDangling(edges.points.size(), 0);
  for (Index i = 0; i < count(cells.edges); ++i)
  {
    const Index e = edges.ofDangling[i];
    if (isDangling[e] || edges.triangles[e].size() > 0)
    {
      throw InvalidInput(
        "line ", i, " of the axis is there twice or is a side of a triangle: ", TakeMedialAxis);
    }
    isDangling[e] = 1;
  }
  std::vector<char> isUsed(pointCount, 0);
  for (const Edge& edge : edges.points)
  {
    isUsed[edge[0]] = isUsed[edge[1]] = 1;
  }
  for (const Index vertex : cells.vertices)
  {
    if (isUsed[vertex])
    {
      throw InvalidInput(
        "vertex ", vertex, " of the axis is there twice or is in a higher cell: ", TakeMedialAxis);
    }
    isUsed[vertex] = 1;
  }
}

void checkTopology(const MedialAxis& axis)
{
  if (bettiNumbers(axis.cells) != axis.betti)
  {
    throw InvalidInput("the field array '", names::BettiAxis,
      "' doesn't tell the topology of the cells: ", TakeMedialAxis);
  }
  if (axis.certificate != (axis.betti == axis.powerShapeBetti))
  {
    throw InvalidInput("the field array '", names::Certificate, "' doesn't say whether '",
      names::BettiAxis, "' and '", names::BettiPowerShape, "' are equal: ", TakeMedialAxis);
  }
}
}

void checkAxis(const MedialAxis& axis)
{
  checkPlaces(axis);
  checkOwners(axis);
  checkVolumes(axis);
  checkCells(axis.cells, count(axis.points));
  checkTopology(axis);
}
}
