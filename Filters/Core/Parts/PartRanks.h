// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PartRanks_h
#define medial_PartRanks_h

#include "Base/Types.h"
#include "Parts/LivingCells.h"
#include "Parts/Measures.h"
#include "Parts/MedialParts.h"

#include <vector>

/// Numbers for people, by which parts are named and coloured: the part with the largest volume has rank
/// 0, the next 1, and so on; of equal ones the lowest part is first. Pruning only joins parts, and what is
/// joined keeps the lowest of the ranks. So a part keeps its rank, but then there are gaps between ranks.
namespace medial
{
/// The rank of each part.
/// @param cellRanks  that each cell has already, which the parts take over; where an axis was cut otherwise
///                   since, and several parts had the same, the largest keeps it and the others come last.
///                   Empty: there are none
std::vector<Index> partRanks(const MedialParts& parts, const std::vector<Index>& cellRanks);

/// For each cell the rank of its part, where an axis has not been pruned.
std::vector<Index> ranksOfCells(LivingCells living, const PartMeasures& measures);

/// The lowest rank of the cells of each part; None where there are no ranks.
std::vector<Index> lowestRanks(
  const std::vector<Index>& partOfCell, Index partCount, const std::vector<Index>& cellRanks);
}

#endif
