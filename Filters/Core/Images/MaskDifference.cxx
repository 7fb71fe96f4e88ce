// SPDX-License-Identifier: BSD-3-Clause
#include "Images/MaskDifference.h"

#include "Images/MaskPieces.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace medial
{
namespace
{
/// The voxel at the centre of 27, and those around it: x + 3 y + 9 z.
using Block = std::array<bool, 27>;
constexpr int Centre = 13;

/// How many steps along axes lead from one voxel of a block to another, and whether the longest is one.
struct Steps
{
  int sum, most;
};

Steps stepsBetween(int a, int b)
{
  Steps result{ 0, 0 };
  for (int axis = 0; axis < 3; ++axis, a /= 3, b /= 3)
  {
    const int step = std::abs(a % 3 - b % 3);
    result.sum += step;
    result.most = std::max(result.most, step);
  }
  return result;
}

/// For each voxel of a block those that touch it: by a face, or by a corner.
using Contacts = std::array<std::vector<int>, 27>;

Contacts contacts(int mostSteps)
{
  Contacts result;
  for (int a = 0; a < 27; ++a)
  {
    for (int b = 0; b < 27; ++b)
    {
      const Steps steps = stepsBetween(a, b);
      if (a != b && steps.most == 1 && steps.sum <= mostSteps)
      {
        result[a].push_back(b);
      }
    }
  }
  return result;
}

/// How many connected pieces of the marked voxels of a block have one of these.
int pieces(Block marked, const Contacts& contacts, const std::vector<int>& having)
{
  int result = 0;
  for (const int first : having)
  {
    if (!marked[first])
    {
      continue;
    }
    ++result;
    std::vector<int> open{ first };
    marked[first] = false;
    while (!open.empty())
    {
      const int at = open.back();
      open.pop_back();
      for (const int to : contacts[at])
      {
        if (marked[to])
        {
          marked[to] = false;
          open.push_back(to);
        }
      }
    }
  }
  return result;
}

/// Does the topology stay if the voxel at the centre changes sides? One piece of the solid and one of
/// what is outside must touch it.
bool isSimple(const Block& inside)
{
  static const Contacts byFace = contacts(1), byCorner = contacts(3);
  Block solid = inside, outside{};
  solid[Centre] = false;
  for (int at = 0; at < 27; ++at)
  {
    outside[at] = at != Centre && !inside[at] && stepsBetween(at, Centre).sum < 3;
  }
  return pieces(solid, byCorner, byCorner[Centre]) == 1 &&
    pieces(outside, byFace, byFace[Centre]) == 1;
}

Block blockAt(const VoxelMask& mask, const std::array<Index, 3>& voxel)
{
  Block result{};
  for (int at = 0; at < 27; ++at)
  {
    result[at] = mask(voxel[0] + at % 3 - 1, voxel[1] + at / 3 % 3 - 1, voxel[2] + at / 9 - 1);
  }
  return result;
}

std::array<Index, 3> voxelAt(const VoxelMask& mask, Index number)
{
  return { number % mask.size[0], number / mask.size[0] % mask.size[1],
    number / mask.size[0] / mask.size[1] };
}

/// The first voxel of the largest group that touches itself by faces. Of a tunnel that opens all voxels along it
/// are left; few are left for no more than the order that they were tried in.
Index inLargestGroup(const VoxelMask& shape, const std::vector<Index>& voxels)
{
  VoxelMask group{ shape.size, std::vector<unsigned char>(shape.inside.size(), 0) };
  for (const Index voxel : voxels)
  {
    group.inside[voxel] = 1;
  }
  const MaskPieces pieces = maskPieces(group, {}, VoxelContact::Contour);
  std::pair<Index, Index> best{ 0, None }; // voxels, and the first one
  std::vector<char> seen(pieces.inside.size(), 0);
  for (Index row = 0; row < pieces.rows.size(); ++row)
  {
    for (const VoxelRun& run : pieces.rows[row])
    {
      if (run.inside && !seen[run.piece] && pieces.voxels[run.piece] > best.first)
      {
        best = { pieces.voxels[run.piece], row * shape.size[0] + run.begin };
      }
      seen[run.piece] = 1;
    }
  }
  return best.second;
}

/// Is a voxel of a block in the box that the centre and a corner of it span?
bool isBetween(int at, int corner)
{
  for (int axis = 0; axis < 3; ++axis, at /= 3, corner /= 3)
  {
    if (at % 3 != 1 && at % 3 != corner % 3)
    {
      return false;
    }
  }
  return true;
}

/// Does the voxel at the centre touch another one by an edge or a corner, with no voxel of the solid between?
bool touchesBarely(const Block& inside)
{
  for (int corner = 0; corner < 27; ++corner)
  {
    bool alone = inside[corner] && stepsBetween(corner, Centre).sum > 1;
    for (int at = 0; alone && at < 27; ++at)
    {
      alone = at == corner || at == Centre || !inside[at] || !isBetween(at, corner);
    }
    if (alone)
    {
      return true;
    }
  }
  return false;
}
}

std::optional<Point> topologyDifference(
  VoxelMask from, const VoxelMask& to, const Execution& execution)
{
  std::vector<Index> different;
  for (Index i = 0; i < count(to.inside); ++i)
  {
    if (from.inside[i] != to.inside[i])
    {
      different.push_back(i);
    }
  }
  for (std::size_t before = different.size() + 1; different.size() < before;)
  {
    before = different.size();
    std::vector<Index> left;
    for (const Index i : different)
    {
      execution.pollAt(i);
      if (isSimple(blockAt(from, voxelAt(from, i))))
      {
        from.inside[i] = to.inside[i];
      }
      else
      {
        left.push_back(i);
      }
    }
    different = std::move(left);
  }
  if (different.empty())
  {
    return std::nullopt;
  }
  const auto [i, j, k] = voxelAt(from, inLargestGroup(from, different));
  return Point(i, j, k);
}

std::optional<Point> bareContact(const VoxelMask& mask, const Execution& execution)
{
  for (Index number = 0; number < count(mask.inside); ++number)
  {
    execution.pollAt(number);
    const std::array<Index, 3> voxel = voxelAt(mask, number);
    if (mask.inside[number] != 0 && touchesBarely(blockAt(mask, voxel)))
    {
      return Point(voxel[0], voxel[1], voxel[2]);
    }
  }
  return std::nullopt;
}
}
