// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CrustOptions_h
#define medial_CrustOptions_h

#include "Base/Types.h"

#include <optional>

namespace medial
{
/// What fills the place of removed inner balls.
///
/// Without them the outer balls around that place meet in the middle of it, and the crust has a
/// stump or a spike there that no kept ball supports.
enum class CrustRule
{
  Clearance = 0, ///< new outer balls, until every vertex of the crust that pruning has touched is a
                 ///< sample or within the clearance from the union of the kept balls. Balls that
                 ///< would take the topology farther from the one wanted are left out. Removed
                 ///< inner balls come back, few of them, where `topology` needs them
  InnerOnly = 1, ///< nothing (paper 5)
  InnerAndOuter = 2 ///< nothing, and the outer balls of their samples are removed as well (paper 5,
                    ///< for sharp corners)
};

struct CrustOptions
{
  CrustRule rule = CrustRule::Clearance;
  double clearance = 1;   ///< in sample spacings; larger than 0
  int maximumRounds = 10; ///< of CrustRule::Clearance: how often balls are added at most

  /// Betti numbers that the solid should have, for example those of the pruned axis. Without: those
  /// of the power shape of the kept balls.
  std::optional<Betti> topology;
};
}

#endif
