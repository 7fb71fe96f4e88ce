// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/FarSpots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
using medial::BoundarySamples;
using medial::FarFace;
using medial::FarSpot;
using medial::FarSpots;
using medial::Index;
using medial::Point;

constexpr double wanted = 0.5, reach = 8;
const Point here(0, 0, 0), nextToHere(12, 0, 0), there(100, 0, 0);

FarFace face(const Point& place, double distance = 1)
{
  return { place, distance, 1 };
}

/// Tries one more sample at each place.
void tryAt(FarSpots& spots, const std::vector<Point>& places, const BoundarySamples& before)
{
  BoundarySamples samples = before;
  for (const Point& place : places)
  {
    samples.points.push_back({ place, Point(0, 0, 1), 0 });
    samples.spacings.push_back(place.x());
  }
  spots.add(samples, static_cast<Index>(before.points.size()));
}

std::vector<double> bestSpacings(const FarSpots& spots)
{
  return spots.with({}, &FarSpot::best).spacings;
}

TEST(FarSpots, KeepTheBestAttemptInEach)
{
  const std::vector<FarFace> faces{ face(here), face(nextToHere), face(there) };
  FarSpots spots(faces, wanted, reach);
  BoundarySamples before;
  before.points.resize(3);
  before.spacings.resize(3);
  tryAt(spots, { Point(1, 0, 0), Point(101, 0, 0) }, before);
  spots.judge({ face(here), face(there), face(there) }); // better here, worse there
  EXPECT_EQ(bestSpacings(spots), (std::vector<double>{ 1 }));
  tryAt(spots, { Point(2, 0, 0), Point(102, 0, 0) }, before);
  spots.judge({ face(here), face(nextToHere), face(here) }); // the other way round
  EXPECT_EQ(bestSpacings(spots), (std::vector<double>{ 1, 101, 102 }));
  EXPECT_EQ(spots.unsolved().size(), 2); // the first faces here
  EXPECT_EQ(spots.left().size(), 3);
}

TEST(FarSpots, PreferFewFarFacesToFewNearlyFarOnes)
{
  const std::vector<FarFace> faces{ face(here) };
  FarSpots spots(faces, wanted, reach);
  tryAt(spots, { Point(1, 0, 0) }, {});
  spots.judge({ face(here, 0.45), face(here, 0.45) });
  EXPECT_EQ(bestSpacings(spots).size(), 1);
  EXPECT_EQ(spots.unsolved().size(), 1);
}

TEST(FarSpots, BeginAgainFromTheBestWhereOthersDoNotGetThere)
{
  const std::vector<FarFace> faces{ face(here), face(nextToHere) };
  FarSpots spots(faces, wanted, reach);
  tryAt(spots, { Point(1, 0, 0) }, {});
  spots.judge({ face(here) });
  std::size_t most = 0;
  for (int i = 0; i < 20; ++i)
  {
    tryAt(spots, { Point(2, 0, 0) }, {});
    spots.judge({ face(here), face(here) });
    most = std::max(most, spots.with({}, &FarSpot::tried).points.size());
  }
  EXPECT_GT(most, 2);
  EXPECT_LT(most, 10);
  EXPECT_EQ(bestSpacings(spots), (std::vector<double>{ 1 }));
}
}
