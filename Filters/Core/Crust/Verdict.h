// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Verdict_h
#define medial_Verdict_h

#include "Base/Types.h"
#include "Base/Warnings.h"

#include <optional>
#include <string>
#include <vector>

namespace medial
{
/// What is known of the axis that a surface was made of.
struct AxisFindings
{
  Betti unpruned;           ///< of the axis as it was made
  Betti pruned;             ///< of its cells now; the same if nothing was pruned
  bool topologyKept = true; ///< no pruning was allowed to change the topology
};

/// What the stages have found out about their results, from the samples to the surface.
struct Findings
{
  Betti powerShape;
  std::optional<AxisFindings> axis; ///< none: the surface was made without an axis
  Betti crust;                      ///< means something only where closed and manifold
  bool closed = false;
  bool manifold = false;
  Warnings warnings; ///< of all stages

  /// Of the solid that the user has, if it is known: a mesh, an image.
  std::optional<Betti> solid;
};

/// Can the surface be trusted?
struct Verdict
{
  bool certified = false;

  /// What differs between the stages, and what else speaks against the word "certified"; a sentence
  /// without a full stop each. Also for a certified surface there can be one: pruning has changed the
  /// topology, as it was allowed to.
  std::vector<std::string> reasons;
};

/// The one verdict on a surface and on all stages before it.
///
/// Certified is a surface for which power shape, axis, pruned axis and crust have the same Betti
/// numbers, and the user's solid if it is known; which is closed and a manifold; and whose samples no
/// warning doubts (Warning::doubtsSolid). The pruned axis may differ from the axis where pruning
/// was allowed to change the topology. An axis made by the fallback has the right topology, so it can be
/// certified; a warning tells of it, see axisWarnings(). Without an axis nothing is certified: what was
/// made of it is not known.
Verdict verdict(const Findings& findings);

/// "certified" or "not certified".
const char* nameOf(const Verdict& verdict);

/// "The surface is not certified: the surface is not closed; ...", for people.
std::string sentenceOf(const Verdict& verdict);
}

#endif
