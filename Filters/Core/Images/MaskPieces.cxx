// SPDX-License-Identifier: BSD-3-Clause
#include "Images/MaskPieces.h"

#include "Base/DisjointSets.h"

// Each row is cut into runs, which are what union-find joins: an image has far fewer runs than voxels. Set 0
// is that of the outside, run r is set r + 1.

namespace medial
{
namespace
{
Lists<VoxelRun> runsOf(const VoxelMask& mask, const Execution& execution)
{
  Lists<VoxelRun> rows;
  const Index width = mask.size[0];
  for (Index row = 0; row < mask.size[1] * mask.size[2]; ++row)
  {
    execution.pollAt(row);
    const unsigned char* voxels = mask.inside.data() + static_cast<std::size_t>(row) * width;
    for (Index begin = 0, end = 0; begin < width; begin = end)
    {
      while (end < width && voxels[end] == voxels[begin])
      {
        ++end;
      }
      rows.items.push_back({ begin, end, voxels[begin] != 0, None });
    }
    rows.close();
  }
  return rows;
}

/// Joins the runs of one kind in two rows.
class RowJoiner
{
public:
  RowJoiner(const Lists<VoxelRun>& rows, DisjointSets& sets)
    : rows(rows)
    , sets(sets)
  {
  }

  /// @param reach  1: voxels that are diagonal to each other touch, too
  void join(Index a, Index b, bool inside, Index reach)
  {
    Index p = this->next(this->rows.offsets[a], a, inside);
    Index q = this->next(this->rows.offsets[b], b, inside);
    while (p < this->rows.offsets[a + 1] && q < this->rows.offsets[b + 1])
    {
      const VoxelRun &first = this->rows.items[p], &second = this->rows.items[q];
      if (first.begin < second.end + reach && second.begin < first.end + reach)
      {
        this->sets.unite(p + 1, q + 1);
      }
      // A run that ends first reaches no later run of the other row: between two runs of a kind is one
      // of the other kind.
      Index& ended = first.end < second.end ? p : q;
      ended = this->next(ended + 1, first.end < second.end ? a : b, inside);
    }
  }

private:
  Index next(Index run, Index row, bool inside) const
  {
    return run < this->rows.offsets[row + 1] && this->rows.items[run].inside != inside ? run + 1
                                                                                       : run;
  }

  const Lists<VoxelRun>& rows;
  DisjointSets& sets;
};

void joinRows(const VoxelMask& mask, const Lists<VoxelRun>& rows, VoxelContact contact,
  DisjointSets& sets, const Execution& execution)
{
  const bool cubes = contact == VoxelContact::Cubes;
  RowJoiner joiner(rows, sets);
  const auto joinSideways = [&](Index row, Index other) {
    joiner.join(row, other, true, cubes ? 1 : 0);
    joiner.join(row, other, false, cubes ? 0 : 1);
  };
  // Of the solid's voxels there all touch as cubes; of those outside the ones that share an edge do in a
  // contour.
  const auto joinDiagonally = [&](Index row, Index other) {
    joiner.join(row, other, cubes, cubes ? 1 : 0);
  };
  for (Index k = 0; k < mask.size[2]; ++k)
  {
    for (Index j = 0; j < mask.size[1]; ++j)
    {
      const Index row = j + k * mask.size[1], below = row - mask.size[1];
      execution.pollAt(row);
      if (j > 0)
      {
        joinSideways(row, row - 1);
      }
      if (k > 0)
      {
        joinSideways(row, below);
      }
      if (k > 0 && j > 0)
      {
        joinDiagonally(row, below - 1);
      }
      if (k > 0 && j + 1 < mask.size[1])
      {
        joinDiagonally(row, below + 1);
      }
    }
  }
}

/// Joins what is not of the solid at the image's border with the outside.
void joinOutside(const VoxelMask& mask, const Lists<VoxelRun>& rows, DisjointSets& sets)
{
  for (Index row = 0; row < rows.size(); ++row)
  {
    const Index j = row % mask.size[1], k = row / mask.size[1];
    const bool isBorder = j == 0 || j + 1 == mask.size[1] || k == 0 || k + 1 == mask.size[2];
    for (Index r = rows.offsets[row]; r < rows.offsets[row + 1]; ++r)
    {
      const VoxelRun& run = rows.items[r];
      if (!run.inside && (isBorder || run.begin == 0 || run.end == mask.size[0]))
      {
        sets.unite(0, r + 1);
      }
    }
  }
}
}

MaskPieces maskPieces(const VoxelMask& mask, const Execution& execution, VoxelContact contact)
{
  MaskPieces result;
  result.rows = runsOf(mask, execution);
  DisjointSets sets(count(result.rows.items) + 1);
  joinRows(mask, result.rows, contact, sets, execution);
  joinOutside(mask, result.rows, sets);
  std::vector<Index> pieceOf(result.rows.items.size() + 1, None);
  pieceOf[0] = MaskPieces::Outside;
  result.inside = { 0 };
  result.voxels = { 0 };
  for (Index r = 0; r < count(result.rows.items); ++r)
  {
    VoxelRun& run = result.rows.items[r];
    Index& piece = pieceOf[sets.find(r + 1)];
    if (piece == None)
    {
      piece = count(result.inside);
      result.inside.push_back(run.inside);
      result.voxels.push_back(0);
    }
    run.piece = piece;
    result.voxels[piece] += run.end - run.begin;
  }
  return result;
}
}
