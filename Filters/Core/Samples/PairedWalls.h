// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PairedWalls_h
#define medial_PairedWalls_h

#include "Samples/BlueNoise.h"

#include <vector>

namespace medial
{
/// Samples, those between near walls in pairs.
struct PairedSamples
{
  std::vector<SurfacePoint> points; ///< the fixed ones first, the partners last
  std::vector<Point> places;        ///< of samples that got a partner
};

/// Gives samples a partner on the opposite wall, of the solid or of a gap, where the walls are parallel and nearer than
/// a width, but not than a fiftieth of the spacing: each is the mirror image of the other, and the sheet of the medial axis lies halfway between them. Samples
/// next to a partner give way. However near the walls are, pairs keep inside and outside apart; but balls between
/// them are as wide as the samples are apart, not as the walls.
/// @param width    what is wider stays as it is
/// @param samples  of the surface
/// @param fixed    so many of them, the first ones, stay
PairedSamples pairAcrossWalls(const TriangleSet& surface, const SurfaceTree& tree,
  const SpacingField& spacing, double width, const std::vector<SurfacePoint>& samples, Index fixed,
  const Execution& execution = {});
}

#endif
