// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/PartRanks.h"

#include "Base/Lists.h"
#include "Parts/Partition.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace medial
{
namespace
{
/// @param lowest  the rank that each part would like to keep
/// @param next    the first rank that no part has
std::vector<Index> distinctRanks(
  const std::vector<double>& volumes, const std::vector<Index>& lowest, Index next)
{
  std::vector<Index> byVolume(volumes.size());
  std::iota(byVolume.begin(), byVolume.end(), 0);
  std::stable_sort(
    byVolume.begin(), byVolume.end(), [&](Index a, Index b) { return volumes[a] > volumes[b]; });
  std::vector<Index> result(volumes.size());
  std::set<Index> taken;
  for (const Index part : byVolume)
  {
    result[part] = taken.insert(lowest[part]).second ? lowest[part] : next++;
  }
  return result;
}

/// All would like to be the first.
std::vector<Index> ranksByVolume(const std::vector<double>& volumes)
{
  return distinctRanks(volumes, std::vector<Index>(volumes.size(), 0), 1);
}
}

std::vector<Index> partRanks(const MedialParts& parts, const std::vector<Index>& cellRanks)
{
  std::vector<double> volumes;
  for (const MedialPart& part : parts.parts)
  {
    volumes.push_back(part.volume);
  }
  if (cellRanks.empty())
  {
    return ranksByVolume(volumes);
  }
  return distinctRanks(volumes, lowestRanks(parts.partOfCell, count(volumes), cellRanks),
    *std::max_element(cellRanks.begin(), cellRanks.end()) + 1);
}

std::vector<Index> ranksOfCells(LivingCells living, const PartMeasures& measures)
{
  const Partition parts = partition(living, 1);
  std::vector<double> volumes = measures.significance(Measure::RelativeVolume, parts);
  for (double& volume : volumes)
  {
    volume *= measures.solidVolume; // rounded as MedialPart::volume, which decides ties
  }
  const std::vector<Index> ranks = ranksByVolume(volumes);
  std::vector<Index> result;
  for (const Index part : parts.partOfCell)
  {
    result.push_back(ranks[part]);
  }
  return result;
}

std::vector<Index> lowestRanks(
  const std::vector<Index>& partOfCell, Index partCount, const std::vector<Index>& cellRanks)
{
  std::vector<Index> result(partCount, None);
  for (Index cell = 0; cell < count(cellRanks); ++cell)
  {
    Index& rank = result[partOfCell[cell]];
    rank = rank == None ? cellRanks[cell] : std::min(rank, cellRanks[cell]);
  }
  return result;
}
}
