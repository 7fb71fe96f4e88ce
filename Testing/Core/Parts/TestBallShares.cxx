// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Parts/BallShares.h"

#include <vector>

using medial::BallShare;
using medial::Index;
using medial::Lists;
using medial::None;
using medial::Point;
using pipelines::forEachShape;
using pipelines::Pipeline;

TEST(BallShares, MakeTheVolumesOfTheParts)
{
  forEachShape([](Pipeline& p) {
    const medial::MedialAxis& axis = p.axis();
    std::vector<double> areas, volumes(p.parts().parts.size(), 0);
    for (Index part = 0; part < medial::count(volumes); ++part)
    {
      areas.push_back(p.parts().value(medial::Measure::Area, part));
    }
    const Lists<BallShare> shares =
      medial::ballShares(axis, p.parts().partOfCell, areas, medial::cellsOfPoints(axis.cells));
    ASSERT_EQ(shares.size(), medial::count(axis.ballVolumes));
    for (Index b = 0; b < shares.size(); ++b)
    {
      const Index owner = axis.ballOwner[b];
      EXPECT_EQ(shares[b].size() > 0, owner == b && owner != None);
      double sum = 0;
      for (const BallShare& held : owner == None ? shares[b] : shares[owner])
      {
        sum += held.share;
        volumes[held.part] += held.share * axis.ballVolumes[b];
      }
      EXPECT_NEAR(sum, owner == None ? 0 : 1, 1e-12);
    }
    for (std::size_t i = 0; i < volumes.size(); ++i)
    {
      EXPECT_NEAR(p.parts().parts[i].volume, volumes[i], 1e-9 * p.shape.volume);
    }
  });
}

// Four triangles about a point, in three parts, and a line from there upwards.
TEST(BallShares, AreThoseOfThePartsSizes)
{
  medial::MedialAxis axis;
  axis.points = { Point(0, 0, 0), Point(1, 1, 0), Point(-1, 1, 0), Point(-1, -1, 0),
    Point(1, -1, 0), Point(0, 0, 1), Point(9, 9, 9) };
  axis.cells.edges = { { 0, 5 } };
  axis.cells.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 3, 4, 0 }, { 0, 4, 1 } };
  axis.ballOfPoint = { 2, None, 0, None, None, 1, None }; // the last point has no cell
  axis.ballOwner = { 0, 1, 2, 2 };
  const medial::IndexLists cells = medial::cellsOfPoints(axis.cells);
  const std::vector<Index> partOfCell{ 3, 0, 0, 1, 2 };
  const auto sharesOf = [&](Index ball, const std::vector<double>& sizes) {
    const Lists<BallShare> shares = medial::ballShares(axis, partOfCell, sizes, cells);
    std::vector<double> result(4, 0);
    for (const BallShare& held : shares[ball])
    {
      result[held.part] = held.share;
    }
    return result;
  };
  const std::vector<double> sizes{ 5, 2, 1, 0 };
  EXPECT_EQ(sharesOf(0, sizes), (std::vector<double>{ 1, 0, 0, 0 })); // a corner of two triangles
  EXPECT_EQ(sharesOf(1, sizes), (std::vector<double>{ 0, 0, 0, 1 })); // the line's end
  EXPECT_EQ(sharesOf(2, sizes), (std::vector<double>{ 0.625, 0.25, 0.125, 0 }));
  EXPECT_EQ(sharesOf(2, { 0, 0, 0, 0 }), (std::vector<double>{ 0.25, 0.25, 0.25, 0.25 }));
  EXPECT_EQ(sharesOf(3, sizes), (std::vector<double>(4, 0))); // off the axis
}
