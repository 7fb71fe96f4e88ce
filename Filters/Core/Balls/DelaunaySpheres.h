// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_DelaunaySpheres_h
#define medial_DelaunaySpheres_h

#include "Base/Execution.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// How precise samples are at least, in their spacing. Samples that dense must be more precise.
constexpr double leastPrecision = 1e-3;

/// The Delaunay triangulation of samples and guards, and its circumspheres: a sphere's centre is a
/// Voronoi vertex. Cells with the same circumsphere, as far as the precision of samples tells, form a
/// class, which has one sphere. All lengths are in the unit of the samples given.
struct DelaunaySpheres
{
  std::vector<Point> points; ///< the samples, then the guards
  Index sampleCount;
  double precision; ///< how far samples may be from where they were meant to be, at most

  /// Distance of each sample to the nearest other one. Two samples closer than `coincident` are the same up to
  /// rounding and don't count as neighbours. Infinite where there is no other one.
  std::vector<double> nearest;
  double meanSpacing; ///< mean of the finite distances, 0 where there is none

  Tetrahedra delaunay;
  // One entry for each cell.
  std::vector<double> cellVolumes;
  std::vector<Index> classOfCell; ///< the lowest cell of its class
  std::vector<Ball> ballOfCell;   ///< the sphere of its class
};

/// @param samples    distinct
/// @param precision  how far each may be from where it was meant to be; counts up to leastPrecision
/// @throw Aborted
DelaunaySpheres delaunaySpheres(
  const std::vector<Point>& samples, double precision, const Execution& execution = {});
}

#endif
