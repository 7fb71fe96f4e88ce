// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_VolumeThickness_h
#define medial_VolumeThickness_h

#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Types.h"
#include "Measuring/Distribution.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace medial
{
/// The part of the volume of interest whose thickness counts.
struct ThicknessBounds
{
  /// Where something larger was cut. None: the bounding box of the samples, which cuts nothing.
  std::optional<Eigen::AlignedBox3d> bounds;

  /// How far inside the bounds thickness counts, since balls at the cut are too small; negative: half the mean thickness,
  /// and where that leaves nothing the thickness isn't known. Only with bounds.
  double margin = -1;
};

/// The thickness of a solid and of what is around it, each a mean over the volume: at points spread evenly.
struct VolumeThickness
{
  Distribution thickness; ///< at points inside
  Distribution
    separation; ///< at points outside, where a ball contains them whose centre is in the bounds
  double margin = 0; ///< that was left out
  double share = 0;  ///< of the volume of interest that is inside the solid
};

/// Thickness is the diameter of the largest inner ball that contains a point [HR97], separation that of the largest outer
/// ball. The diameter of a ball is twice its wall distance, so that bulges don't count.
/// @param distances  wallDistances() of the balls
/// @param number     of points inside, and at most of points outside; fewer where the solid fills less than 5 % of the
///                   volume
/// @throw InvalidInput  bounds that are empty, or a margin of 0 or more that leaves nothing of them
/// @throw Aborted
VolumeThickness volumeThickness(const PolarBalls& balls, const std::vector<double>& distances,
  const ThicknessBounds& volume = {}, Index number = 10000, const Execution& execution = {});
}

#endif
