// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MedialAxis_h
#define medial_MedialAxis_h

#include "Axis/SiteView.h"
#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The cells of a medial axis: triangles, and the edges and vertices in no higher cell.
///
/// Cells are numbered vertices first, then edges, then triangles, as in a vtkPolyData.
struct AxisCells
{
  std::vector<Index> vertices;
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;

  Index size() const { return this->firstTriangle() + count(this->triangles); }
  Index firstEdge() const { return count(this->vertices); }
  Index firstTriangle() const { return count(this->vertices) + count(this->edges); }
};

/// Calls body(point) for the corners of a cell.
template <typename Body>
void forPoints(const AxisCells& cells, Index cell, const Body& body)
{
  if (cell >= cells.firstTriangle())
  {
    const Triangle& corners = cells.triangles[cell - cells.firstTriangle()];
    body(corners[0]), body(corners[1]), body(corners[2]);
  }
  else if (cell >= cells.firstEdge())
  {
    const Edge& ends = cells.edges[cell - cells.firstEdge()];
    body(ends[0]), body(ends[1]);
  }
  else
  {
    body(cells.vertices[cell]);
  }
}

/// The medial axis of the solid: the triangulated surface of the centres of its maximal balls.
struct MedialAxis
{
  // One entry for each medial point.
  std::vector<Point> points;
  std::vector<double> radii;      ///< of the maximal ball centred there, unit of the samples
  std::vector<Index> ballOfPoint; ///< the polar ball centred there, or None
  std::vector<double> erosion;    ///< Erosion::ofPoint of the axis as it was made

  AxisCells cells;
  // One entry for each cell.
  std::vector<Index> polygonOfCell; ///< triangles of one Voronoi face share a number; else None
  std::vector<Edge> samplesOfCell;  ///< the two sites the cell is equally far from, where they are
                                    ///< samples, else None
  std::vector<SiteView> siteViews;
  std::vector<double> cellErosion; ///< Erosion::ofCell of the axis as it was made

  // One entry for each polar ball.
  std::vector<Index> ballOwner; ///< itself if on the axis; for an inner ball off the axis the ball
                                ///< on the axis whose fate it shares; None for other balls
  std::vector<double> ballVolumes; ///< PolarBalls::volumes
  std::vector<double> poleVolumes; ///< PolarBalls::poleVolumes

  double sampleDiagonal = 0; ///< of the samples' bounding box; 0: not known

  Betti powerShapeBetti;
  Betti betti;      ///< of points and cells above, computed from them
  bool certificate; ///< betti == powerShapeBetti
  bool fallback;    ///< made by collapse of the power shape, not from the singular points
  double kappa;     ///< which candidates were taken, see Filters/README.md; -1 with the fallback
};

/// What to do where the axis from the singular points does not have the power shape's topology.
enum class AxisFallback
{
  Collapse, ///< collapse the power shape: exact topology, rougher sheets
  Nearest   ///< keep the axis whose Betti numbers come nearest; the certificate says false
};

struct AxisOptions
{
  AxisFallback fallback = AxisFallback::Collapse;
};

/// The medial axis (paper 3) as Voronoi faces of the singular points inside the shape, triangulated,
/// without duplicate vertices, with the Betti numbers of the power shape as certificate.
///
/// @throw InvalidInput  no inner balls, or cells that are no triangulation
/// @throw Aborted
MedialAxis medialAxis(
  const PolarBalls& polarBalls, const AxisOptions& options = {}, const Execution& execution = {});

/// The axis with some of its cells, given in ascending order, alone; all points stay.
/// @param betti  of these cells; the certificate follows
MedialAxis withCells(MedialAxis axis, const std::vector<Index>& cells, const Betti& betti);

double triangleArea(const MedialAxis& axis, const Triangle& corners);

/// The maximal balls at the corners of a cell.
std::vector<Ball> cornerBalls(const MedialAxis& axis, Index cell);

/// Betti numbers of the complex of `cells` and their faces. Exact, over Z/2.
Betti bettiNumbers(const AxisCells& cells);
}

#endif
