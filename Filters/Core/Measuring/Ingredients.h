// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Ingredients_h
#define medial_Ingredients_h

#include "Axis/MedialAxis.h"
#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Measuring/Morphometry.h"
#include "Measuring/VolumeOfInterest.h"

#include <optional>
#include <vector>

namespace medial
{
/// What morphometry takes from the stages.
struct MeasuredSolid
{
  const PolarBalls& balls; ///< with the samples; thickness is unknown where there are no balls
  const MedialAxis& axis;
  const std::vector<Point>& points; ///< of the surface
  const std::vector<Triangle>& triangles;
};

/// Measures volumes, areas, topology, anisotropy and thickness; plates and rods are left unknown. Of a surface
/// that is not closed only areas and thickness are known.
/// @param bounds, margin  see volumeOfInterest(). With neither the solid is measured whole, though its surface
///                        may be outside the samples' bounding box, which is TV, by less than their spacing.
///                        Thickness is measured farther inside, see volumeThickness(): by half the mean
///                        thickness where there is no margin, and unknown where that leaves nothing.
/// @throw InvalidInput    nothing is left of the volume of interest
MorphometryIngredients ingredients(const MeasuredSolid& solid,
  const std::optional<Eigen::AlignedBox3d>& bounds = {}, double margin = 0,
  const Execution& execution = {});
}

#endif
