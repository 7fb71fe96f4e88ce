// SPDX-License-Identifier: BSD-3-Clause
#include "Complexes.h"
#include "Pipelines.h"

#include "Parts/MedialParts.h"
#include "Pruning/Pruning.h"

#include <cmath>
#include <vector>

using medial::Index;
using medial::Measure;
using medial::MedialAxis;
using medial::MedialParts;
using medial::Point;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
std::vector<double> boundaryLengths(const MedialAxis& axis)
{
  return medial::decompose(axis).values[static_cast<int>(Measure::BoundaryLength)];
}
}

TEST(BoundaryLength, OfARectangleIsItsPerimeter)
{
  complexes::Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(0.5, 0, 0), Point(0, 2, 0), 6, 4);
  EXPECT_EQ(boundaryLengths(drawing.axis()), (std::vector<double>{ 2 * (3 + 8) }));
}

TEST(BoundaryLength, DoesNotCountASeam)
{
  // A fin on a sheet: its foot is no border, and where it stands the sheet has none.
  complexes::Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 8, 8);
  drawing.sheet(Point(4, 2, 0), Point(0, 1, 0), Point(0, 0, 1), 4, 3);
  EXPECT_EQ(boundaryLengths(drawing.axis()), (std::vector<double>{ 32, 3 + 4 + 3 }));
}

TEST(BoundaryLength, OfLinesAndVerticesIsNothing)
{
  complexes::Drawing drawing;
  drawing.edge(drawing.point(0, 0, 0), drawing.point(1, 0, 0));
  drawing.vertex(drawing.point(5, 0, 0));
  EXPECT_EQ(boundaryLengths(drawing.axis()), (std::vector<double>{ 0, 0 }));
}

TEST(BoundaryLength, OfAllPartsIsThatOfTheAxis)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis& axis = p.axis();
    const medial::AxisEdges edges = medial::axisEdges(axis.cells);
    double border = 0, sum = 0;
    for (Index e = 0; e < medial::count(edges.points); ++e)
    {
      const auto [a, b] = edges.points[e];
      border += edges.triangles[e].size() == 1 ? (axis.points[a] - axis.points[b]).norm() : 0;
    }
    for (const double length : boundaryLengths(axis))
    {
      sum += length;
    }
    EXPECT_NEAR(sum, border, 1e-9 * border);
  });
}

TEST(BoundaryLength, OfALivingRestCountsWhatHasBecomeFree)
{
  // Without the fin and one half of the sheet the middle of the sheet is its border.
  complexes::Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 4, 4);
  drawing.sheet(Point(4, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 2, 4);
  drawing.sheet(Point(4, 0, 0), Point(0, 0, 1), Point(0, 1, 0), 2, 4);
  const MedialAxis axis = drawing.axis();
  EXPECT_EQ(boundaryLengths(axis), (std::vector<double>{ 12, 8, 8 }));
  medial::PruneOptions options;
  options.schedule = medial::parseSchedule("b9x1");
  const medial::Pruned pruned = medial::prune(axis, options);
  EXPECT_EQ(
    pruned.parts.values[static_cast<int>(Measure::BoundaryLength)], (std::vector<double>{ 16 }));
}
