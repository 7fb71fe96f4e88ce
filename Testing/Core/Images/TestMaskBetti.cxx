// SPDX-License-Identifier: BSD-3-Clause
#include "Images/MaskBetti.h"

#include "Masks.h"

#include <gtest/gtest.h>

#include <bitset>
#include <cmath>
#include <vector>

using masks::cube;
using medial::Betti;
using medial::Index;
using medial::maskBetti;
using medial::VoxelMask;

namespace
{
/// The cells of the voxels, from the ranks of their boundary matrices over Z/2. A cell is a place of a
/// grid with twice as many steps: odd coordinates are those along which it extends.
class CubicalComplex
{
public:
  explicit CubicalComplex(const VoxelMask& mask)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Size[axis] = 2 * mask.size[axis] + 1;
    }
    for (Index k = 0; k < this->Size[2]; ++k)
    {
      for (Index j = 0; j < this->Size[1]; ++j)
      {
        for (Index i = 0; i < this->Size[0]; ++i)
        {
          this->add(mask, { i, j, k });
        }
      }
    }
  }

  Betti betti() const
  {
    const Index r1 = this->rank(1), r2 = this->rank(2), r3 = this->rank(3);
    return { this->count(0) - r1, this->count(1) - r1 - r2, this->count(2) - r2 - r3 };
  }

private:
  using Cell = std::array<Index, 3>;
  using Chain = std::bitset<1024>;

  void add(const VoxelMask& mask, const Cell& c)
  {
    for (Index corner = 0; corner < 8; ++corner)
    {
      const auto voxel = [&](int axis) { return (c[axis] - (corner >> axis & 1)) / 2; };
      const bool isThere =
        c[0] >= (corner & 1) && c[1] >= (corner >> 1 & 1) && c[2] >= (corner >> 2 & 1);
      if (isThere && mask(voxel(0), voxel(1), voxel(2)))
      {
        this->Cells[c[0] % 2 + c[1] % 2 + c[2] % 2].push_back(c);
        return;
      }
    }
  }

  Index count(int dimension) const { return medial::count(this->Cells[dimension]); }

  std::size_t number(const Cell& c) const
  {
    return static_cast<std::size_t>((c[2] * this->Size[1] + c[1]) * this->Size[0] + c[0]);
  }

  Chain boundary(const Cell& cell) const
  {
    Chain result;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const Index step : { -1, 1 })
      {
        Cell side = cell;
        side[axis] += step;
        result.flip(cell[axis] % 2 == 1 ? this->number(side) : Chain().size() - 1);
      }
    }
    return result;
  }

  Index rank(int dimension) const
  {
    std::vector<Chain> byLowest(Chain().size());
    Index result = 0;
    for (const Cell& cell : this->Cells[dimension])
    {
      Chain chain = this->boundary(cell);
      for (std::size_t i = chain._Find_first(); i < chain.size(); i = chain._Find_first())
      {
        if (byLowest[i].none())
        {
          byLowest[i] = chain;
          ++result;
          break;
        }
        chain ^= byLowest[i];
      }
    }
    return result;
  }

  std::array<Index, 3> Size;
  std::array<std::vector<Cell>, 4> Cells;
};

VoxelMask few(const std::vector<std::array<Index, 3>>& voxels)
{
  VoxelMask mask{ { 4, 4, 4 }, std::vector<unsigned char>(64, 0) };
  for (const auto& [i, j, k] : voxels)
  {
    mask.inside[mask.row(j, k) + i] = 1;
  }
  return mask;
}

TEST(MaskBetti, OfSolidsThatEveryoneKnows)
{
  const auto ball = [](double x, double y, double z) { return x * x + y * y + z * z < 0.7; };
  EXPECT_EQ(maskBetti(cube(20, ball)), (Betti{ 1, 0, 0 }));
  const auto shell = [&](double x, double y, double z) {
    return ball(x, y, z) && x * x + y * y + z * z > 0.3;
  };
  EXPECT_EQ(maskBetti(cube(20, shell)), (Betti{ 1, 0, 1 }));
  const auto torus = [](double x, double y, double z) {
    return std::pow(std::hypot(x, y) - 0.6, 2) + z * z < 0.06;
  };
  EXPECT_EQ(maskBetti(cube(20, torus)), (Betti{ 1, 1, 0 }));
  const auto island = [&](double x, double y, double z) {
    return shell(x, y, z) || x * x + y * y + z * z < 0.1;
  };
  EXPECT_EQ(maskBetti(cube(20, island)), (Betti{ 2, 0, 1 }));
}

TEST(MaskBetti, OfNothingAndOfEverything)
{
  EXPECT_EQ(maskBetti(cube(3, [](double, double, double) { return false; })), (Betti{ 0, 0, 0 }));
  EXPECT_EQ(maskBetti(cube(3, [](double, double, double) { return true; })), (Betti{ 1, 0, 0 }));
}

TEST(MaskBetti, OfVoxelsThatMeetAtAnEdgeOrACorner)
{
  EXPECT_EQ(maskBetti(few({ { 1, 1, 1 }, { 2, 2, 1 } })), (Betti{ 1, 0, 0 }));
  EXPECT_EQ(maskBetti(few({ { 1, 1, 1 }, { 2, 2, 2 } })), (Betti{ 1, 0, 0 }));
  EXPECT_EQ(maskBetti(few({ { 2, 1, 1 }, { 1, 2, 2 } })), (Betti{ 1, 0, 0 }));
  EXPECT_EQ(maskBetti(few({ { 0, 0, 0 }, { 2, 0, 0 } })), (Betti{ 2, 0, 0 }));
  EXPECT_EQ(
    maskBetti(few({ { 1, 0, 0 }, { 0, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 } })), (Betti{ 1, 1, 0 }));
}

TEST(MaskBetti, OfRandomMasksAreThoseOfTheirCells)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    const double density = 0.1 + 0.8 * (seed % 9) / 8;
    const VoxelMask mask = masks::random({ 4, 3, 5 }, density, seed);
    EXPECT_EQ(maskBetti(mask), CubicalComplex(mask).betti()) << "seed " << seed;
  }
}

TEST(MaskBetti, OfARowAreItsRuns)
{
  EXPECT_EQ(maskBetti({ { 7, 1, 1 }, { 1, 0, 1, 1, 0, 0, 1 } }), (Betti{ 3, 0, 0 }));
}
}
