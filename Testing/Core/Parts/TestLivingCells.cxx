// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Parts/BettiNumbers.h"
#include "Parts/LivingCells.h"
#include "Parts/Partition.h"

#include <utility>
#include <vector>

namespace
{
using complexes::Drawing;
using medial::Index;
using medial::LivingCells;
using medial::MedialAxis;
using medial::Partition;
using medial::Point;

/// Two floors that meet along a line of 40 edges; on the line fins, one behind the other from 0 to 40, which wings divide.
/// @param starts  of the fins, ascending
MedialAxis floorsUnderFins(const std::vector<int>& starts)
{
  const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const int length = 40;
  Drawing drawing;
  drawing.sheet(Point(0, -2, 0), x, y, length, 2);
  drawing.sheet(Point(0, 0, 0), x, y, length, 2);
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    const int end = i + 1 < starts.size() ? starts[i + 1] : length;
    drawing.sheet(starts[i] * x, x, z, end - starts[i], 1);
    if (starts[i] > 0)
    {
      drawing.sheet(starts[i] * x, z, Point(0.3, 1, 2), 1, 1);
    }
  }
  return drawing.axis();
}

/// A floor, a tube that stands on it, and a lid in the floor that closes the tube below.
/// @param width  of the tube and the lid, in cells
MedialAxis floorWithTube(int width)
{
  const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const Point low(1, 1, 0), right = low + width * x, behind = low + width * y;
  Drawing drawing;
  drawing.sheet(low, x, y, width, width);
  drawing.sheet(Point::Zero(), x, y, width + 2, 1);
  drawing.sheet(y, x, y, 1, width);
  drawing.sheet(right, x, y, 1, width);
  drawing.sheet((width + 1) * y, x, y, width + 2, 1);
  drawing.sheet(low, x, z, width, 1);
  drawing.sheet(low, y, z, width, 1);
  drawing.sheet(right, y, z, width, 1);
  drawing.sheet(behind, x, z, width, 1);
  return drawing.axis();
}

/// Two walls on a floor, and a shelf between them, whose corners are all on the walls.
MedialAxis shelf()
{
  const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  Drawing drawing;
  drawing.sheet(Point::Zero(), x, y, 3, 1);
  drawing.sheet(Point::Zero(), x, z, 3, 2);
  drawing.sheet(y, x, z, 3, 2);
  drawing.sheet(x + z, x, y, 1, 1);
  return drawing.axis();
}

/// An axis that loses parts.
class Shrinking
{
public:
  explicit Shrinking(MedialAxis theAxis)
    : axis(std::move(theAxis))
  {
  }

  /// The cells of the part that holds the triangle with its middle nearest to a place.
  std::vector<Index> partAt(const Point& place) const
  {
    double least = 1e9;
    Index part = medial::None;
    for (Index t = 0; t < medial::count(this->axis.cells.triangles); ++t)
    {
      const auto& [a, b, c] = this->axis.cells.triangles[t];
      const Point middle = (this->axis.points[a] + this->axis.points[b] + this->axis.points[c]) / 3;
      if ((middle - place).norm() < least)
      {
        least = (middle - place).norm();
        part = this->partition.partOfCell[this->axis.cells.firstTriangle() + t];
      }
    }
    return { this->partition.cells[part].begin(), this->partition.cells[part].end() };
  }

  void removePartAt(const Point& place)
  {
    this->living.remove(this->partAt(place));
    this->partition = medial::partition(this->living);
  }

  void joinScraps()
  {
    this->living.joinScraps();
    this->partition = medial::partition(this->living);
  }

  Index parts() const { return this->partition.cells.size(); }

  MedialAxis axis;
  medial::AxisEdges edges = medial::axisEdges(axis.cells);
  LivingCells living{ axis.cells, edges };
  Partition partition = medial::partition(living);
};

TEST(LivingCells, KeepTwoPartsApartAtANotchInAThird)
{
  Shrinking floors(floorsUnderFins({ 0, 38 }));
  ASSERT_EQ(floors.parts(), 5);
  floors.removePartAt(Point(39.5, 0, 0.5));
  EXPECT_EQ(floors.parts(), 3); // the floors, and the fin with its wing
  EXPECT_NE(floors.partAt(Point(39.5, 1, 0)), floors.partAt(Point(39.5, -1, 0)));
  EXPECT_EQ(medial::bettiNumbers(floors.living, floors.partition), (medial::Betti{ 1, 0, 0 }));
  Index contacts = 0;
  for (Index e = 0; e < medial::count(floors.edges.points); ++e)
  {
    contacts += floors.living.isContact(e);
  }
  EXPECT_EQ(contacts, 40); // the whole line
  floors.removePartAt(Point(10, 0, 0.5));
  EXPECT_EQ(floors.parts(), 1); // nothing keeps them apart any more
}

TEST(LivingCells, JoinTwoPartsWhereMuchOfAThirdHasGone)
{
  Shrinking floors(floorsUnderFins({ 0, 30 }));
  floors.removePartAt(Point(35.5, 0, 0.5));
  EXPECT_EQ(floors.parts(), 2);
}

TEST(LivingCells, JoinTwoPartsOnceTheNotchHasBecomeLong)
{
  Shrinking floors(floorsUnderFins({ 0, 3, 37 })); // scraps at both ends of the line
  ASSERT_EQ(floors.parts(), 7);
  floors.removePartAt(Point(38.5, 0, 0.5));
  EXPECT_EQ(floors.parts(), 5); // 3 edges against 37
  floors.removePartAt(Point(1.5, 0, 0.5));
  EXPECT_EQ(floors.parts(), 2); // 6 against 34
}

TEST(LivingCells, JoinScrapsToTheirNeighbors)
{
  for (const int width : { 1, 2 })
  {
    Shrinking lid(floorWithTube(width));
    ASSERT_EQ(lid.parts(), 3);
    lid.joinScraps();
    EXPECT_EQ(lid.parts(), 2);
    EXPECT_EQ(
      lid.partAt(Point(1.5, 1.5, 0)), lid.partAt(Point(0.5, 0.5, 0))); // the first of equal ones
  }
}

TEST(LivingCells, LeaveWhatIsNoScrap)
{
  Shrinking withInside(floorWithTube(3)); // the lid has four points that are not on its border
  ASSERT_EQ(withInside.parts(), 3);
  withInside.joinScraps();
  EXPECT_EQ(withInside.parts(), 3);
  Shrinking withFreeEdges(shelf());
  ASSERT_EQ(withFreeEdges.parts(), 2);
  withFreeEdges.joinScraps();
  EXPECT_EQ(withFreeEdges.parts(), 2);
}
}
