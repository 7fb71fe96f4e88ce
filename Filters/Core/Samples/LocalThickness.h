// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_LocalThickness_h
#define medial_LocalThickness_h

#include "Base/Execution.h"
#include "Base/SurfaceTree.h"
#include "Base/Types.h"

#include <array>
#include <vector>

namespace medial
{
/// A point of a surface.
struct SurfacePoint
{
  Point position;
  Point normal; ///< of its triangle, outwards, of length 1
  Index triangle;
};

std::vector<Point> positions(const std::vector<SurfacePoint>& samples);
std::vector<Point> normals(const std::vector<SurfacePoint>& samples);

/// A piece of an edge where two walls meet in a wedge.
struct WedgeEdge
{
  std::array<Point, 2> ends;    ///< of a piece of it
  std::array<Point, 2> normals; ///< of the two walls, of length 1
};

/// How thick the solid is at samples of its surface, or the gap outside, whichever is less: the diameter
/// of the largest ball that touches the surface there and is free of it, if the ball touches an opposite
/// wall, or the surface bends around it. Infinite where the ball only reaches into an edge, where the two
/// walls meet at one of the given edges (a wedge is as thin as one likes there), and where there is nothing
/// opposite.
///
/// Exact straight across; beside that, what is thinner than the samples are apart can be missed.
/// Costs a few searches in trees for each sample; they take longer the larger the balls are.
/// @param triangleNormals  of the surface in the tree, of length 1
/// @param most             what is thicker counts as infinitely thick; finite
/// @param first            only from this sample on; those before are known, but keep balls small, too
/// @return                 one value for each sample from the first on
std::vector<double> localThickness(const std::vector<SurfacePoint>& samples,
  const SurfaceTree& tree, const std::vector<Point>& triangleNormals, double most,
  const std::vector<WedgeEdge>& edges = {}, const Execution& execution = {}, Index first = 0);
}

#endif
