// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MedialAxis_h
#define medial_MedialAxis_h

#include "Axis/AxisComplex.h"
#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The medial axis of the solid: the triangulated surface of the centres of its maximal balls.
struct MedialAxis : AxisComplex
{
  std::vector<double> erosion;     ///< for each point, Erosion::ofPoint of the axis as it was made
  std::vector<double> cellErosion; ///< for each cell, Erosion::ofCell of the axis as it was made

  // One entry for each polar ball.
  std::vector<Index> ballOwner; ///< itself if on the axis; for an inner ball off the axis the ball
                                ///< on the axis whose fate it shares; None for other balls
  std::vector<double> ballVolumes; ///< PolarBalls::volumes
  std::vector<double> poleVolumes; ///< PolarBalls::poleVolumes

  double sampleDiagonal = 0; ///< of the samples' bounding box; 0: not known
  double sampleSpacing = 0;  ///< of the balls; 0: not known

  Betti powerShapeBetti;
  Betti betti;      ///< of points and cells above, computed from them
  bool certificate; ///< betti == powerShapeBetti
  bool fallback;    ///< pieces of it, maybe all, were made by collapse of the power shape, not from
                    ///< the singular points
  double kappa;     ///< least depth of the candidates that were taken, see insideCells() in
                    ///< Carving.h and depth in SiteTriangulation.h; -1 with the fallback
  Index
    filledGaps; ///< places where cells that are less deep join pieces, or fill tunnels or voids, that
                ///< would be too many, see fillGaps(); 0 with the fallback
};

/// What to do where the axis from the singular points does not have the power shape's topology.
enum class AxisFallback
{
  Collapse, ///< collapse the power shape: exact topology, coarser triangles
  Nearest   ///< keep the axis whose Betti numbers come nearest; the certificate says false
};

struct AxisOptions
{
  AxisFallback fallback = AxisFallback::Collapse;

  /// Rims up to this erosion thickness are left out, see RimTrimming.h: in local spacings of the samples, the mean
  /// distances from their six nearest; 0: none. The solid stays: balls left out share the fate of others.
  double trim = 0;
};

/// The medial axis (paper 3) as Voronoi faces of the singular points inside the shape, triangulated,
/// without duplicate vertices, with the Betti numbers of the power shape as certificate.
///
/// @throw InvalidInput  no inner balls, cells that are no triangulation, or a negative trim
/// @throw Aborted
MedialAxis medialAxis(
  const PolarBalls& polarBalls, const AxisOptions& options = {}, const Execution& execution = {});

/// The axis with some of its cells, given in ascending order, alone; all points stay.
/// @param betti  of these cells; the certificate follows
MedialAxis withCells(MedialAxis axis, const std::vector<Index>& cells, const Betti& betti);
}

#endif
