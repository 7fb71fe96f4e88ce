// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PlateAndRodMeans_h
#define medial_PlateAndRodMeans_h

#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <Eigen/Geometry>

#include <limits>
#include <vector>

namespace medial
{
/// Plates and rods of a solid in a box, all of them together. Lengths are in the unit of the samples. Means are weighted by
/// volume; not a number where there is nothing to weigh.
struct PlateAndRodMeans
{
  /// Of the volume in the box. By the width at each point, not by whole elements: none where it is up to 1.25, all
  /// where it is from 1.75 thicknesses on; none in rods that meet no plate.
  double plateShare = std::numeric_limits<double>::quiet_NaN();
  double rodShare = plateShare;
  Index plates = 0; ///< whose centroid is in the box
  Index rods = 0;
  double plateThickness = plateShare;
  double rodThickness = plateShare;
  double plateWidth = plateShare; ///< without closed sheets, which have none
  double plateArea = plateShare;  ///< of a plate, each alike
  double rodLength = plateShare;  ///< of a rod, each alike

  // Of the whole solid, see PlatesAndRods.
  Index plateJunctions = 0, mixedJunctions = 0, rodJunctions = 0;
};

/// @param distances  wallDistances() of the balls that the axis was made from: of these are the thicknesses, so that
///                   bulges between samples don't count
/// @throw Aborted
PlateAndRodMeans plateAndRodMeans(const MedialAxis& axis, const std::vector<double>& distances,
  const Eigen::AlignedBox3d& box, const Execution& execution = {});
}

#endif
