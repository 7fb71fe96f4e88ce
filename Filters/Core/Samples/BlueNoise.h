// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_BlueNoise_h
#define medial_BlueNoise_h

#include "Base/Execution.h"
#include "Samples/LocalThickness.h"
#include "Samples/SpacingField.h"

#include <array>
#include <vector>

namespace medial
{
/// Triangles with their normals and areas.
struct TriangleSet
{
  const std::vector<Point>& points;
  const std::vector<Triangle>& triangles;
  std::vector<Point> normals; ///< of length 1; 0 where there is no area
  std::vector<double> areas;
};

TriangleSet triangleSet(const std::vector<Point>& points, const std::vector<Triangle>& triangles);

/// The middle of a triangle.
SurfacePoint middleOf(const TriangleSet& surface, Index triangle);

/// How many samples there are in a square as wide as their spacing; measured.
constexpr double samplesPerSquare = 0.7;

/// A part of a triangle in which the spacing hardly changes.
struct SurfacePiece
{
  std::array<Point, 3> corners;
  Index triangle;
  double spacing;

  Point middle() const { return (this->corners[0] + this->corners[1] + this->corners[2]) / 3; }
};

/// The triangles that have an area in pieces, in the order of the triangles.
std::vector<SurfacePiece> surfacePieces(
  const TriangleSet& surface, const SpacingField& spacing, const Execution& execution = {});

/// About how many samples the spacing asks for.
double expectedSamples(const std::vector<SurfacePiece>& pieces);

/// Random samples of a surface that are evenly spread: no two are nearer than the spacing at the first one,
/// and almost no gap is wider. The same surface gives the same samples.
///
/// Candidates are thrown at the pieces, several for each sample; in random order each is taken, and
/// those within its spacing are dropped. O(n log n).
/// @param pieces   of the surface, or of parts of it, in the order of their triangles
/// @param taken    samples that there are already, which keep others away; a little less far, so that no
///                 wide gap remains beside them
/// @param spacing  at those; that of the pieces is in them
std::vector<SurfacePoint> blueNoise(const TriangleSet& surface,
  const std::vector<SurfacePiece>& pieces, const std::vector<SurfacePoint>& taken,
  const SpacingField& spacing, const Execution& execution = {});
}

#endif
