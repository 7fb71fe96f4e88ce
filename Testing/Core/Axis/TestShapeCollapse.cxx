// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/ShapeCollapse.h"
#include "Pipelines.h"

#include "Axis/AxisBetti.h"
#include "Axis/Erosion.h"

using medial::Index;
using medial::MedialAxis;
using medial::None;
using medial::Point;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
MedialAxis collapsedAxis(const medial::PolarBalls& balls, const medial::PowerShape& shape)
{
  MedialAxis axis{};
  static_cast<medial::AxisComplex&>(axis) = medial::collapsedShape(balls);
  axis.betti = medial::bettiNumbers(axis.cells);
  axis.powerShapeBetti = shape.betti;
  axis.ballOwner.assign(balls.balls.size(), None);
  for (const Index b : axis.ballOfPoint)
  {
    axis.ballOwner[b] = b;
  }
  axis.ballVolumes = balls.volumes;
  axis.poleVolumes = balls.poleVolumes;
  medial::Erosion erosion = medial::erosion(axis);
  axis.erosion = erosion.ofPoint;
  axis.cellErosion = erosion.ofCell;
  return axis;
}

double areaOf(const MedialAxis& axis)
{
  double sum = 0;
  for (const medial::Triangle& t : axis.cells.triangles)
  {
    sum += medial::triangleArea(axis, t);
  }
  return sum;
}
}

TEST(ShapeCollapse, HasTheTopologyOfThePowerShape)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis axis = collapsedAxis(p.balls(), p.powerShape());
    EXPECT_EQ(pipelines::independentBetti(axis), p.powerShape().betti);
  });
  for (unsigned seed = 0; seed < 12; ++seed) // no solids at all
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const medial::PolarBalls balls =
      medial::polarBalls(shapes::cloud(40 + 20 * static_cast<int>(seed), seed));
    const medial::PowerShape shape = medial::powerShape(balls);
    EXPECT_EQ(pipelines::independentBetti(collapsedAxis(balls, shape)), shape.betti);
  }
}

TEST(ShapeCollapse, IsAsCleanAsTheAxisFromTheSingularPoints)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis axis = collapsedAxis(p.balls(), p.powerShape());
    const Index parts = medial::count(medial::decompose(axis).parts);
    EXPECT_LE(parts, 2 * medial::count(p.parts().parts) + 10);
    // Where the exact axis is a curve, next to nothing: strips narrower than the spacing.
    const double strips = 1e-3 * p.diagonal * p.diagonal;
    EXPECT_LT(areaOf(axis), 1.1 * areaOf(p.axis()) + strips);
  });
}

TEST(ShapeCollapse, HasNearlyAllPolesAndNoOtherPoints)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis axis = collapsedAxis(p.balls(), p.powerShape());
    const Index inner = pipelines::howMany(p.balls(), medial::Side::Inner);
    EXPECT_GT(medial::count(axis.points), 0.99 * inner);
    for (std::size_t i = 0; i < axis.points.size(); ++i)
    {
      ASSERT_EQ(p.balls().sides[axis.ballOfPoint[i]], medial::Side::Inner);
      ASSERT_EQ(axis.points[i], p.balls().balls[axis.ballOfPoint[i]].center);
      ASSERT_EQ(axis.radii[i], p.balls().balls[axis.ballOfPoint[i]].radius);
    }
    EXPECT_EQ(
      validators::unusedPoints(medial::count(axis.points), complexes::complexOf(axis.cells)), 0);
  });
}

TEST(ShapeCollapse, KnowsTheTwoSamplesOfMostTriangles)
{
  forEachShape([](Pipeline& p) {
    const medial::AxisComplex axis = medial::collapsedShape(p.balls());
    Index known = 0;
    for (Index t = 0; t < medial::count(axis.cells.triangles); ++t)
    {
      for (const Index sample : axis.samplesOfCell[axis.cells.firstTriangle() + t])
      {
        known += sample != None;
        for (const Index corner : axis.cells.triangles[t])
        {
          if (sample != None)
          {
            ASSERT_NEAR((axis.points[corner] - p.shape.samples[sample]).norm(), axis.radii[corner],
              1e-7 * p.diagonal);
          }
        }
      }
    }
    EXPECT_GE(known, 0.5 * medial::count(axis.cells.triangles)); // of twice as many
  });
}

TEST(ShapeCollapse, LiesOnTheExactAxis)
{
  forEachShape([](Pipeline& p) {
    const medial::AxisComplex axis = medial::collapsedShape(p.balls());
    double sum = 0, areas = 0;
    for (const medial::Triangle& t : axis.cells.triangles)
    {
      const Point centroid = (axis.points[t[0]] + axis.points[t[1]] + axis.points[t[2]]) / 3;
      const double area = medial::triangleArea(axis, t);
      sum += area * p.shape.axisDistance(centroid);
      areas += area;
    }
    // Triangles are chords of a curved axis, with sides of about one or two spacings.
    EXPECT_LE(sum, 0.15 * p.shape.spacing * areas);
  });
}

TEST(ShapeCollapse, HasAnEntryForEachCell)
{
  forEachShape([](Pipeline& p) {
    const medial::AxisComplex axis = medial::collapsedShape(p.balls());
    EXPECT_EQ(medial::count(axis.polygonOfCell), axis.cells.size());
    EXPECT_EQ(medial::count(axis.samplesOfCell), axis.cells.size());
    EXPECT_EQ(medial::count(axis.siteViews), axis.cells.size());
  });
}
