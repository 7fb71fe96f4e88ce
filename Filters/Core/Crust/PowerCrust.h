// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PowerCrust_h
#define medial_PowerCrust_h

#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Types.h"

#include <optional>
#include <vector>

namespace medial
{
/// What becomes of the place of removed inner balls.
enum class CrustRule
{
  Clearance =
    0, ///< outer balls are added until no free vertex of the crust that pruning has touched
       ///< is farther from the union of the kept balls than the clearance; none where
       ///< that would take the topology away from the one wanted
  InnerOnly = 1,    ///< nothing (paper 5)
  InnerAndOuter = 2 ///< the outer balls of their samples go as well (paper 5, sharp corners)
};

struct CrustOptions
{
  CrustRule rule = CrustRule::Clearance;
  double clearance = 1; ///< in sample spacings
  int maximumRounds = 10;
  std::optional<Betti>
    topology; ///< that the solid should have, as of the pruned axis; without: that
              ///< of the power shape of the kept balls
};

/// The power crust: the faces between inner and outer cells of the balls' power diagram (paper 5,
/// [ACK01]). Closed and oriented outwards.
struct Crust
{
  // One entry for each point.
  std::vector<Point> points;
  std::vector<Index> sampleOfPoint; ///< the sample that the point is, or None

  // One entry for each face, a polygon.
  IndexLists faces;             ///< points, counter-clockwise seen from outside
  std::vector<Index> innerBall; ///< the ball behind the face
  std::vector<Index>
    outerBall; ///< the ball before it; None for a ball added by CrustRule::Clearance

  Betti betti;             ///< of the solid that the crust encloses
  bool closed;             ///< every edge between two faces, in opposite directions
  bool manifold;           ///< and the faces at every point form one fan
  double volume;           ///< enclosed, cube of the samples' unit
  Index insertedBalls;     ///< by CrustRule::Clearance
  Index refusedBalls;      ///< not inserted: the topology would have changed
  int rounds;              ///< of insertion made
  double maximumClearance; ///< largest distance of a point that is no sample to the union of the
                           ///< kept balls, in sample spacings; 0 where none is outside
};

/// The power crust of the inner balls with keep[ball] != 0 and the outer balls.
///
/// @param keep  one entry for each ball; empty: all inner balls
/// @throw InvalidInput  no inner ball is kept, `keep` doesn't fit, or a clearance that isn't positive
Crust powerCrust(const PolarBalls& polarBalls, const std::vector<char>& keep = {},
  const CrustOptions& options = {}, const Execution& execution = {});
}

#endif
