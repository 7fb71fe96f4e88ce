// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SheetMerging_h
#define medial_SheetMerging_h

#include "Base/DisjointSets.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// What speaks for two sets being one, or, where it is negative, against it.
struct Bond
{
  Index a, b;
  double strength;
};

/// Unites the two sets with the strongest bond, then those with the strongest of what is left, until no
/// bond is above a tenth of all that a set has, each amount counted: less is a gap in a border. The bonds of a
/// set are the sums of those of its members, so a small one that binds two sets is outweighed by a large
/// one against it. Of equally strong bonds that of the lowest members comes first. Takes O(n log^2 n)
/// time.
/// @param bonds  between members of sets; those within a set are left out
void mergeByBonds(
  DisjointSets& sets, const std::vector<Bond>& bonds, const Execution& execution = {});
}

#endif
