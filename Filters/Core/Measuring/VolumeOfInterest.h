// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_VolumeOfInterest_h
#define medial_VolumeOfInterest_h

#include "Base/Execution.h"
#include "Base/Types.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

/// What of a solid lies in a box. Surfaces are triangles, counter-clockwise seen from outside. Linear in their
/// number; nothing is cut into cells, so that no case is special: a box may touch corners and edges.
namespace medial
{
/// The box that numbers are measured in.
/// @param bounds  none: the bounding box of the samples
/// @param margin  it is smaller by this much on each of its six sides
/// @throw InvalidInput  nothing is left of it; no samples
Eigen::AlignedBox3d volumeOfInterest(const std::vector<Point>& samples,
  const std::optional<Eigen::AlignedBox3d>& bounds = {}, double margin = 0);

/// For each triangle its normal, as long as the area of what of it is in the box.
std::vector<Point> areasWithin(const Eigen::AlignedBox3d& box, const std::vector<Point>& points,
  const std::vector<Triangle>& triangles, const Execution& execution = {});

/// The sum of the lengths of these.
double areaOf(const std::vector<Point>& areas);

/// The volume of the solid in the box, of a closed surface: over each place of the box's floor the lengths
/// within the box up to triangles that look upwards, less those up to triangles that look downwards.
double volumeWithin(const Eigen::AlignedBox3d& box, const std::vector<Point>& points,
  const std::vector<Triangle>& triangles, const Execution& execution = {});

/// The box's share of the Euler characteristic of the solid, of a closed manifold: the sum over the surface's
/// points in the box of (360 degrees - the angles of the triangles there) / 720 degrees. Over the whole surface
/// this is the Euler characteristic (Gauss and Bonnet). The shares of boxes side by side add up, so that a
/// box has no edge effects; a share is no whole number.
double eulerWithin(const Eigen::AlignedBox3d& box, const std::vector<Point>& points,
  const std::vector<Triangle>& triangles, const Execution& execution = {});
}

#endif
