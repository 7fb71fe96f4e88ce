// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PowerCrust_h
#define medial_PowerCrust_h

#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/SolidMeasures.h"
#include "Base/Types.h"
#include "Base/Warnings.h"
#include "Crust/CrustOptions.h"
#include "Crust/CrustSurface.h"
#include "Crust/SampleDistances.h"

#include <vector>

namespace medial
{
/// The power crust: the triangulated faces between inner and outer cells of the balls' power diagram
/// (paper 5, [ACK01]), closed and oriented outwards, in the samples' unit. `outerBall` is None for a
/// ball that CrustRule::Clearance has added.
struct Crust
  : CrustSurface
  , SolidMeasures
{
  Index putBackBalls = 0; ///< removed inner balls that the topology needs; see CrustRule::Clearance
  Index insertedBalls = 0; ///< by CrustRule::Clearance
  Index refusedBalls = 0;  ///< not inserted: the topology would have changed
  int rounds = 0;          ///< of insertion made
  double maximumClearance =
    0;                   ///< largest distance of a point that is no sample to the union of the
                         ///< kept balls and those put back, in sample spacings; 0 where none is
                         ///< outside
  SampleDistances moved; ///< what lies between samples and surface; 0 where all balls are kept
  Warnings warnings;     ///< "crust_topology": other Betti numbers than CrustOptions::topology
};

/// The power crust of the inner balls with keep[ball] != 0 and the outer balls.
///
/// Where all balls are kept, the triangulation of `polarBalls` is used; else the regular triangulation
/// of the balls that are left is made anew, which takes most of the time.
/// @param keep  one entry for each ball; empty: all inner balls
/// @throw InvalidInput  no inner ball is kept, `keep` doesn't fit, or a clearance that isn't positive
Crust powerCrust(const PolarBalls& polarBalls, const std::vector<char>& keep = {},
  const CrustOptions& options = {}, const Execution& execution = {});
}

#endif
