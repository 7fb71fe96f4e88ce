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
/// @param angle     in degrees
/// @param straight  in degrees: edges where they differ by more have none
std::vector<SharpLine> sharpLines(const TriangleSet& surface, double angle, double straight = 180);

/// Short pieces of the lines, to find the walls that meet there. Lines shorter than a few spacings have none.
std::vector<WedgeEdge> wedgeEdges(
  const TriangleSet& surface, const std::vector<SharpLine>& lines, double spacing);

/// Samples in pairs on both sides of sharp edges, each the mirror image of the other: half a spacing from
/// the edge, about a spacing apart along it. Halfway between the two is the plane in which the sheet of
/// the medial axis runs into the edge. In a narrow wedge there are more such rows, up to where it is two
/// spacings thick: nearer to the edge, samples that are no pairs don't keep inside and outside apart.
///
/// Where the faces beside an edge are too narrow or too curved for that there is none. Lines shorter than
/// a few spacings have none: they are noise of a scan.
std::vector<SurfacePoint> mirroredSamples(const TriangleSet& surface, const SurfaceTree& tree,
  const SpacingField& spacing, const std::vector<SharpLine>& lines);
}

#endif
