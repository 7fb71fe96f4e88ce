// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SampleEvidence_h
#define medial_SampleEvidence_h

#include "Base/Frame.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <array>
#include <vector>

namespace medial
{
/// What doubts are drawn from: the distinct samples and their balls. All lengths are in one frame.
struct SampleEvidence
{
  const Frame& frame;
  const std::vector<Point>& points;                       ///< the distinct samples
  const std::vector<std::array<Index, 2>>& ballsOfSample; ///< first and second pole, or None
  const std::vector<Ball>& balls;
  const std::vector<Side>& sides;

  // The regular triangulation of the balls.
  const Tetrahedra& mesh;
  const std::vector<Edge>& edges;

  /// Local spacing of each sample: its distance to the sixth nearest other one. Six neighbours surround
  /// a sample of an evenly sampled surface, at 1.4 to 1.7 times the distance of the nearest one. The
  /// sixth depends less on chance than the first.
  const std::vector<double>& spacings;

  // Of the samples on each ball.
  const std::vector<double>& largestSpacings;
  const std::vector<double>& meanSpacings;
};
}

#endif
