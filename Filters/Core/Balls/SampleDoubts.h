// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SampleDoubts_h
#define medial_SampleDoubts_h

#include "Balls/DistinctSamples.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

#include <array>
#include <vector>

namespace medial
{
/// The samples and the balls made of them, in the frame.
struct DoubtInput
{
  const std::vector<Point>& samples; ///< as they were given
  const DistinctSamples& distinct;
  const std::vector<std::array<Index, 2>>& ballsOfSample; ///< of each distinct sample, or None
  const std::vector<Ball>& balls;
  const std::vector<Side>& sides;
  const IndexLists& ballSamples;  ///< by their numbers in `samples`
  const Tetrahedra& mesh;         ///< the balls' regular triangulation, with neighbours
  const std::vector<Edge>& edges; ///< of the mesh
  const Betti& powerShape;        ///< Betti numbers of the power shape
};

/// What is doubtful about samples and balls. `Filters/README.md` lists the codes. Takes O(n log n) time.
/// Lengths are measured in the local spacing, so that unit, position and density don't matter.
Warnings sampleDoubts(const DoubtInput& input, const Execution& execution = {});
}

#endif
