// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_AxisComplex_h
#define medial_AxisComplex_h

#include "Axis/AxisCells.h"
#include "Axis/SiteView.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The points and cells of a medial axis, and where they come from.
struct AxisComplex
{
  // One entry for each medial point.
  std::vector<Point> points;
  std::vector<double> radii;      ///< of the maximal ball centred there, unit of the samples
  std::vector<Index> ballOfPoint; ///< the polar ball centred there, or None

  AxisCells cells;
  // One entry for each cell.
  std::vector<Index> polygonOfCell; ///< triangles of one Voronoi face share a number; else None
  std::vector<Edge> samplesOfCell;  ///< the two sites the cell is equally far from, where they are
                                    ///< samples, else None
  std::vector<SiteView> siteViews;
};

/// Area of a triangle of the axis, unit of the samples squared.
double triangleArea(const AxisComplex& axis, const Triangle& corners);

/// Appends what is known of a cell beside its corners to that of another complex's cells.
void appendCellData(const AxisComplex& from, Index cell, AxisComplex& to);

/// The maximal balls at all points.
std::vector<Ball> maximalBalls(const AxisComplex& axis);

/// The maximal balls at the corners of a cell.
std::vector<Ball> cornerBalls(const AxisComplex& axis, Index cell);
}

#endif
