// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/ShrinkingShape.h"

#include "Balls/MarkedBetti.h"
#include "Base/Triangulations.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
using medial::Ball;
using medial::Betti;
using medial::Index;
using medial::Point;
using medial::RegularTriangulation;
using medial::Tetrahedron;

/// Balls of all sizes, every other one inner, and balls to add.
struct Scene
{
  explicit Scene(unsigned seed)
  {
    const std::vector<Point> centers = shapes::cloud(120, seed),
                             sizes = shapes::cloud(120, seed + 1);
    std::vector<Ball> balls;
    for (std::size_t b = 0; b < centers.size(); ++b)
    {
      balls.push_back({ centers[b], 0.3 * std::abs(sizes[b].x()) });
      this->inner.push_back(sizes[b].y() > 0);
    }
    this->triangulation.insert(balls);
  }

  Betti betti(const RegularTriangulation& of) const
  {
    std::vector<char> marks = this->inner;
    marks.resize(marks.size() + 1, 0);
    return medial::markedBetti(of.tetrahedra(), marks);
  }

  RegularTriangulation with(const Ball& ball) const
  {
    RegularTriangulation result = this->triangulation.copy();
    result.insert({ ball });
    return result;
  }

  RegularTriangulation triangulation;
  std::vector<char> inner;
};

TEST(ReplacedCells, AreThoseThatAreGone)
{
  const Scene scene(3);
  for (const Point& center : shapes::cloud(20, 9))
  {
    const Ball ball{ center, 0.2 };
    const auto sorted = [](std::vector<Tetrahedron> cells) {
      medial::sortCells(cells);
      return cells;
    };
    std::vector<Tetrahedron> gone = sorted(scene.triangulation.replacedBy(ball)), expected;
    gone.erase(std::remove_if(gone.begin(), gone.end(),
                 [](const Tetrahedron& cell) { return cell[0] == medial::None; }),
      gone.end());
    const std::vector<Tetrahedron> before = sorted(scene.triangulation.tetrahedra().cells);
    const std::vector<Tetrahedron> after = sorted(scene.with(ball).tetrahedra().cells);
    std::set_difference(
      before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(expected));
    EXPECT_EQ(gone, expected);
  }
}

TEST(NumbersBefore, AreThoseOfCellsThatStay)
{
  const Scene scene(3);
  for (const Point& center : shapes::cloud(5, 9))
  {
    const std::vector<Tetrahedron> before = scene.triangulation.tetrahedra().cells;
    const RegularTriangulation then = scene.with({ center, 0.2 });
    const std::vector<Index> numbers = then.numbersBefore();
    const std::vector<Tetrahedron> after = then.tetrahedra().cells;
    ASSERT_EQ(numbers.size(), after.size());
    for (std::size_t c = 0; c < after.size(); ++c)
    {
      EXPECT_EQ(numbers[c] == medial::None,
        std::find(before.begin(), before.end(), after[c]) == before.end());
      if (numbers[c] != medial::None)
      {
        EXPECT_EQ(before[numbers[c]], after[c]);
      }
    }
  }
}

TEST(ShrinkingShape, KeepsItsTopologyWhereItCollapses)
{
  int collapsing = 0, others = 0, changed = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const Scene scene(10 * seed);
    const Betti before = scene.betti(scene.triangulation);
    for (const Point& center : shapes::cloud(30, 10 * seed + 5))
    {
      const Ball ball{ center, 0.1 };
      const Betti after = scene.betti(scene.with(ball));
      if (medial::shrinksByCollapses(scene.triangulation.replacedBy(ball), scene.inner))
      {
        EXPECT_EQ(after, before) << "seed " << seed;
        ++collapsing;
      }
      else
      {
        ++others;
        changed += after != before;
      }
    }
  }
  EXPECT_GT(collapsing, 100);
  EXPECT_GT(changed, 0.9 * others); // it is seldom too careful
}

TEST(ShrinkingShape, LosesNothingToAHiddenBall)
{
  const Scene scene(1);
  EXPECT_TRUE(medial::shrinksByCollapses({}, scene.inner));
}
}
