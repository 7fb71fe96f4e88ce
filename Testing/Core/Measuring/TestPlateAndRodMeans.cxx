// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/PlateAndRodMeans.h"

#include "Base/Frame.h"
#include "Measuring/SampleWalls.h"
#include "Shapes.h"
#include "Struts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using medial::MedialAxis;
using medial::PlateAndRodMeans;
using medial::Point;
using medial::PolarBalls;

namespace
{
/// Of a solid, in the part of its bounding box below this share of x.
PlateAndRodMeans meansOf(const shapes::Shape& shape, double share = 1)
{
  const PolarBalls balls = medial::polarBalls(shape.samples);
  Eigen::AlignedBox3d box = medial::boundingBox(balls.samples);
  box.max().x() = box.min().x() + share * box.sizes().x();
  return plateAndRodMeans(medial::medialAxis(balls), wallDistances(balls, sampleWalls(balls)), box);
}
}

TEST(PlateAndRodMeans, OfAPlateAreItsThicknessAndWidth)
{
  const PlateAndRodMeans means = meansOf(shapes::hollowSphere());
  EXPECT_EQ(means.plates, 1);
  EXPECT_EQ(means.rods, 0);
  EXPECT_NEAR(means.plateShare, 1, 1e-12);
  EXPECT_NEAR(means.rodShare, 0, 1e-12);
  EXPECT_NEAR(means.plateThickness, 0.5, 0.01); // by radii 8 % more
  EXPECT_TRUE(std::isnan(means.rodThickness));
  EXPECT_TRUE(std::isnan(means.plateWidth)); // it has no border
  EXPECT_NEAR(means.plateArea, 4 * 3.14159 * 0.75 * 0.75, 0.2);

  const PlateAndRodMeans holes = meansOf(shapes::twoHolePlate());
  EXPECT_GT(holes.plateShare, 0.9);
  EXPECT_NEAR(holes.plateThickness, 0.4, 0.01);
  EXPECT_GT(holes.plateWidth, 0.6);
  EXPECT_LT(holes.plateWidth, 1.6); // the plate is 2.8 x 1.6
}

TEST(PlateAndRodMeans, OfARodAreItsThickness)
{
  const PlateAndRodMeans means = meansOf(shapes::torus());
  EXPECT_EQ(means.plates, 0);
  EXPECT_EQ(means.rods, 1);
  EXPECT_EQ(means.rodShare, 1);
  EXPECT_NEAR(means.rodThickness, 1.4, 0.014);
  EXPECT_TRUE(std::isnan(means.plateThickness));
  EXPECT_NEAR(means.rodLength, 4 * 3.14159, 0.2);
  EXPECT_EQ(means.rodJunctions, 0);
}

TEST(PlateAndRodMeans, CountElementsWhoseCentroidIsInTheBox)
{
  const PlateAndRodMeans part = meansOf(shapes::twoHolePlate(), 0.25);
  EXPECT_EQ(part.plates, 0); // the plate's centroid is in the middle
  EXPECT_GT(part.plateShare, 0.5);
  EXPECT_NEAR(part.plateThickness, 0.4, 0.01);
}

TEST(PlateAndRodMeans, ShareTheVolumeByWidth)
{
  const auto plateShare = [](const std::vector<Point>& samples) {
    shapes::Shape shape;
    shape.samples = samples;
    const PlateAndRodMeans means = meansOf(shape);
    EXPECT_NEAR(means.plateShare + means.rodShare, 1, 1e-12);
    return means.plateShare;
  };
  // Where rods meet there are sheets, which are no plates.
  EXPECT_EQ(plateShare(shapes::strutSamples(shapes::tetrahedronFrame(), 0.25, 0.09, 1)), 0);
  EXPECT_NEAR(plateShare(shapes::strutSamples(shapes::platesAndRod(), 0.12, 0.05, 1)), 0.94, 0.02);
  EXPECT_GT(plateShare(shapes::ellipticRod(1, 0.5, 0.1, 1)), 0.98);
}
