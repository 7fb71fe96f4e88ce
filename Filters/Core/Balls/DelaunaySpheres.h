// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_DelaunaySpheres_h
#define medial_DelaunaySpheres_h

#include "Base/Execution.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The Delaunay triangulation of samples and guards, and its circumspheres: a sphere's centre is a
/// Voronoi vertex. Cells with the same circumsphere form a class, which has one sphere. All lengths
/// are in the unit of the samples given.
struct DelaunaySpheres
{
  std::vector<Point> points; ///< the samples, then the guards
  Index sampleCount;
  Tetrahedra delaunay;
  // One entry for each cell.
  std::vector<double> cellVolumes;
  std::vector<Index> classOfCell; ///< the lowest cell of its class
  std::vector<Ball> ballOfCell;   ///< the sphere of its class
};

/// @param samples  distinct
/// @throw Aborted
DelaunaySpheres delaunaySpheres(const std::vector<Point>& samples, const Execution& execution = {});

/// Mean distance of a sample to the nearest other one. Two samples closer than `coincident` are the
/// same up to rounding and don't count as neighbours. 0 where no two samples do.
double meanSpacing(const DelaunaySpheres& spheres);
}

#endif
