// SPDX-License-Identifier: BSD-3-Clause
#include "Base/SolidMeasures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using medial::Betti;
using medial::Index;
using medial::Point;
using medial::SolidMeasures;
using medial::Triangle;

namespace
{
struct Surface
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;

  /// A tetrahedron with a corner at `place`.
  void add(const Point& place, double size, bool isVoid)
  {
    const Index first = medial::count(this->points);
    this->points.push_back(place);
    for (int k = 0; k < 3; ++k)
    {
      this->points.push_back(place + size * Point::Unit(k));
    }
    for (Triangle triangle : { Triangle{ 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } })
    {
      if (isVoid)
      {
        std::swap(triangle[1], triangle[2]);
      }
      for (Index& corner : triangle)
      {
        corner += first;
      }
      this->triangles.push_back(triangle);
    }
  }

  SolidMeasures measures() const { return medial::solidMeasures(this->points, this->triangles); }
};

/// As large as a Frame allows, and with all bits of its coordinates in use.
const Point corner(0.123456789, 0.567891234, 0.891234567);
}

TEST(SolidMeasures, OfATetrahedron)
{
  Surface surface;
  surface.add(corner, 0.3, false);
  const SolidMeasures measures = surface.measures();
  EXPECT_TRUE(measures.closed && measures.manifold);
  EXPECT_EQ(measures.betti, (Betti{ 1, 0, 0 }));
  EXPECT_NEAR(measures.volume, 0.3 * 0.3 * 0.3 / 6, 1e-12);
}

TEST(SolidMeasures, TellTinyPiecesFromTinyVoids)
{
  for (int exponent = 1; exponent <= 12; ++exponent)
  {
    SCOPED_TRACE(testing::Message() << "size 1e-" << exponent);
    Surface surface;
    surface.add(Point(-0.9, -0.9, -0.9), 2.7, false);
    surface.add(corner, std::pow(10, -exponent), false);
    surface.add(-corner, std::pow(10, -exponent), true);
    EXPECT_EQ(surface.measures().betti, (Betti{ 2, 0, 1 }));
  }
}

TEST(SolidMeasures, SeeAHole)
{
  Surface surface;
  surface.add(corner, 0.3, false);
  surface.triangles.pop_back();
  EXPECT_FALSE(surface.measures().closed);
  EXPECT_FALSE(surface.measures().manifold);
}

TEST(SolidMeasures, SeeAPinch)
{
  Surface surface;
  surface.add(corner, 0.3, false);
  surface.add(corner, -0.3, true);
  for (Triangle& triangle : surface.triangles)
  {
    std::replace(triangle.begin(), triangle.end(), Index(4), Index(0));
  }
  EXPECT_TRUE(surface.measures().closed);
  EXPECT_FALSE(surface.measures().manifold);
}
