// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/FreePlaces.h"
#include "Base/Frame.h"
#include "Shapes.h"
#include "Validators.h"

#include <gtest/gtest.h>

using medial::coincident;
using medial::FreePlaces;
using medial::Point;

TEST(FreePlaces, TakeAPlaceThatIsFree)
{
  FreePlaces places({ { 0, 0, 0 }, { 1, 0, 0 } });
  EXPECT_EQ(places.takeNear({ 0.5, 0, 0 }), Point(0.5, 0, 0));
  EXPECT_EQ(places.takeNear({ coincident, 0, 0 }), Point(coincident, 0, 0));
}

TEST(FreePlaces, LieApartAroundOneThatIsTaken)
{
  const Point middle(0.1, -0.2, 0.3);
  std::vector<Point> all{ middle };
  FreePlaces places(all);
  for (int i = 0; i < 30; ++i)
  {
    all.push_back(places.takeNear(middle));
    EXPECT_LT((all.back() - middle).norm(), 4 * coincident);
  }
  EXPECT_EQ(validators::nearDuplicates(all, 0.49 * coincident), 0);
}

TEST(FreePlaces, LieApartWhereVerticesCrowd)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::vector<Point> all; // as close together as vertices can be
    for (const Point& place : shapes::scaled(shapes::cloud(200, seed), 6 * coincident))
    {
      all.push_back(place);
      if (validators::nearDuplicates(all, coincident) > 0)
      {
        all.pop_back();
      }
    }
    const std::size_t n = all.size();
    ASSERT_GT(n, 20u);
    FreePlaces places(all);
    for (std::size_t i = 0; i < 2 * n; ++i)
    {
      all.push_back(places.takeNear(0.5 * (all[i] + all[(7 * i + 1) % n])));
    }
    EXPECT_EQ(validators::nearDuplicates(all, 0.49 * coincident), 0);
  }
}
