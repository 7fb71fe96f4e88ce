// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Midpoints.h"

#include "Base/Frame.h"
#include "Shapes.h"
#include "Validators.h"

#include <gtest/gtest.h>

using medial::coincident;
using medial::Edge;
using medial::Index;
using medial::midpointPlaces;
using medial::Point;

TEST(Midpoints, LieInTheMiddleWhereNothingElseDoes)
{
  const std::vector<Point> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const std::vector<Point> places =
    midpointPlaces(points, { 0, 0, 0 }, { { 0, 1 }, { 2, 0 }, { 3, 1 } });
  EXPECT_EQ(places, (std::vector<Point>{ { 0.5, 0, 0 }, { 0, 0.5, 0 }, { 0.75, 0, 0 } }));
  EXPECT_TRUE(midpointPlaces(points, { 0, 0, 0 }, {}).empty());
}

TEST(Midpoints, OfSidesBetweenTheSamePlacesLieApart)
{
  // Vertices 0, 1 and 2 were at one place, and had sides to the same neighbour.
  const Point a(0.1, 0.2, 0.3), b(0.4, 0.4, 0.4);
  std::vector<Point> points{ a, a, a, b };
  const std::vector<Point> places =
    midpointPlaces(points, { 0, 1, 1, 0 }, { { 1, 3 }, { 2, 3 }, { 0, 3 } });
  EXPECT_EQ(validators::nearDuplicates(places, 0.49 * coincident), 0);
  for (const Point& place : places)
  {
    EXPECT_LT((place - 0.5 * (a + b)).norm(), 2 * coincident);
  }
}

TEST(Midpoints, LieApartWhereVerticesCrowd)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    // As close together as vertices can be.
    std::vector<Point> points;
    for (const Point& place : shapes::cloud(200, seed))
    {
      points.push_back(6 * coincident * place);
      if (validators::nearDuplicates(points, coincident) > 0)
      {
        points.pop_back();
      }
    }
    const Index n = medial::count(points);
    ASSERT_GT(n, 20);
    std::vector<Edge> sides;
    for (Index i = 0; i < n; ++i)
    {
      sides.insert(sides.end(), { { i, (i + 1) % n }, { (i + 2) % n, n + 2 * i } });
    }
    const std::vector<Point> places = midpointPlaces(points, std::vector<char>(n, 0), sides);
    points.insert(points.end(), places.begin(), places.end());
    EXPECT_EQ(validators::nearDuplicates(points, 0.49 * coincident), 0);
  }
}
