// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SampleWalls_h
#define medial_SampleWalls_h

#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <Eigen/Core>

#include <vector>

namespace medial
{
/// What the surface is like around a sample.
struct SampleWall
{
  Point normal = Point::Zero(); ///< outwards, of length 1; zero where nothing tells
  /// How the normal changes: by -curvature * step for a small step along the surface. Zero where it isn't known.
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
};

/// The walls at all samples, fitted to the nearest samples on the same wall. Normals that came with the samples stay as
/// they are.
std::vector<SampleWall> sampleWalls(const PolarBalls& balls, const Execution& execution = {});

/// How far the centre of each ball is from the walls that it touches, the mean over its samples; at most its radius, and
/// its radius where no wall is known.
///
/// A ball passes through its samples and bulges beyond a flat wall between them: with a spacing of a quarter of the
/// thickness by about a tenth. So its radius is too large a thickness of plates; of rods it is right.
/// @param walls  one for each sample
std::vector<double> wallDistances(const PolarBalls& balls, const std::vector<SampleWall>& walls);
}

#endif
