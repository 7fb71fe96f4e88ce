// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SharpEdges_h
#define medial_SharpEdges_h

#include "Samples/BlueNoise.h"

#include <array>
#include <vector>

namespace medial
{
/// An edge between two triangles that meet at an angle.
struct SharpEdge
{
  Edge ends; ///< in the direction in which the first triangle has them
  std::array<Index, 2> triangles;
};

/// A line of sharp edges, each beginning where the one before ends; it turns nowhere sharply.
using SharpLine = std::vector<SharpEdge>;

/// The lines along which the normals of triangles differ by more than an angle. A line ends at a corner,
/// where it turns or where three meet.
/// @param angle  in degrees
std::vector<SharpLine> sharpLines(const TriangleSet& surface, double angle);

/// Samples in pairs on both sides of sharp edges, each the mirror image of the other: half a spacing from
/// the edge, about a spacing apart along it. Halfway between the two is the plane in which the sheet of
/// the medial axis runs into the edge.
///
/// Where the faces beside an edge are too narrow or too curved for that there is none. Lines shorter than
/// a few spacings have none: they are noise of a scan.
std::vector<SurfacePoint> mirroredSamples(const TriangleSet& surface, const SurfaceTree& tree,
  const SpacingField& spacing, const std::vector<SharpLine>& lines);
}

#endif
