// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Parts/BettiNumbers.h"
#include "Parts/LivingCells.h"
#include "Parts/Partition.h"

#include <vector>

namespace
{
using complexes::Drawing;
using medial::Index;
using medial::LivingCells;
using medial::MedialAxis;
using medial::Partition;
using medial::Point;

/// Two floors that meet along a line of some edges; on the line a fin, which ends in a scrap that a wing divides from it.
/// @param scrap  edges of the line that the scrap takes
MedialAxis floorsUnderAFin(int length, int scrap)
{
  const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  Drawing drawing;
  drawing.sheet(Point(0, -2, 0), x, y, length, 2);
  drawing.sheet(Point(0, 0, 0), x, y, length, 2);
  drawing.sheet(Point(0, 0, 0), x, z, length - scrap, 1);
  drawing.sheet((length - scrap) * x, x, z, scrap, 1);
  drawing.sheet((length - scrap) * x, z, Point(0.3, 1, 2), 1, 1);
  return drawing.axis();
}

/// The cells of the part that holds the triangle with its middle nearest to a place.
std::vector<Index> partAt(const MedialAxis& axis, const Partition& partition, const Point& place)
{
  double least = 1e9;
  Index part = medial::None;
  for (Index t = 0; t < medial::count(axis.cells.triangles); ++t)
  {
    const auto& [a, b, c] = axis.cells.triangles[t];
    const Point middle = (axis.points[a] + axis.points[b] + axis.points[c]) / 3;
    if ((middle - place).norm() < least)
    {
      least = (middle - place).norm();
      part = partition.partOfCell[axis.cells.firstTriangle() + t];
    }
  }
  return { partition.cells[part].begin(), partition.cells[part].end() };
}

TEST(LivingCells, KeepTwoPartsApartAtANotchInAThird)
{
  const MedialAxis axis = floorsUnderAFin(40, 2);
  const medial::AxisEdges edges = medial::axisEdges(axis.cells);
  LivingCells living(axis.cells, edges);
  Partition partition = medial::partition(living);
  ASSERT_EQ(partition.cells.size(), 5u);
  living.remove(partAt(axis, partition, Point(39.5, 0, 0.5)));
  partition = medial::partition(living);
  EXPECT_EQ(partition.cells.size(), 3u); // the floors, and the fin with its wing
  EXPECT_NE(
    partAt(axis, partition, Point(39.5, 1, 0)), partAt(axis, partition, Point(39.5, -1, 0)));
  EXPECT_EQ(medial::bettiNumbers(living, partition), (medial::Betti{ 1, 0, 0 }));
  Index contacts = 0;
  for (Index e = 0; e < medial::count(edges.points); ++e)
  {
    contacts += living.isContact(e);
  }
  EXPECT_EQ(contacts, 40); // the whole line
  living.remove(partAt(axis, partition, Point(10, 0, 0.5)));
  EXPECT_EQ(medial::partition(living).cells.size(), 1u); // nothing keeps them apart any more
}

TEST(LivingCells, JoinTwoPartsWhereMuchOfAThirdHasGone)
{
  const MedialAxis axis = floorsUnderAFin(40, 10);
  const medial::AxisEdges edges = medial::axisEdges(axis.cells);
  LivingCells living(axis.cells, edges);
  living.remove(partAt(axis, medial::partition(living), Point(35.5, 0, 0.5)));
  EXPECT_EQ(medial::partition(living).cells.size(), 2u);
}

TEST(LivingCells, JoinTwoPartsOnceTheNotchHasBecomeLong)
{
  // Scraps at both ends of the line, which go one after the other.
  const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  Drawing drawing;
  drawing.sheet(Point(0, -2, 0), x, y, 40, 2);
  drawing.sheet(Point(0, 0, 0), x, y, 40, 2);
  for (const double from : { 0.0, 3.0, 37.0 })
  {
    drawing.sheet(from * x, x, z, from == 3 ? 34 : 3, 1);
    if (from > 0)
    {
      drawing.sheet(from * x, z, Point(0.3, 1, 2), 1, 1);
    }
  }
  const MedialAxis axis = drawing.axis();
  const medial::AxisEdges edges = medial::axisEdges(axis.cells);
  LivingCells living(axis.cells, edges);
  Partition partition = medial::partition(living);
  ASSERT_EQ(partition.cells.size(), 7u);
  living.remove(partAt(axis, partition, Point(38.5, 0, 0.5)));
  partition = medial::partition(living);
  EXPECT_EQ(partition.cells.size(), 5u); // 3 edges against 37
  living.remove(partAt(axis, partition, Point(1.5, 0, 0.5)));
  partition = medial::partition(living);
  EXPECT_EQ(partition.cells.size(), 2u); // 6 against 34
}
}
