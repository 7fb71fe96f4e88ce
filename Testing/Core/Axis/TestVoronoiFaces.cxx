// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/VoronoiFaces.h"
#include "Base/Triangulations.h"
#include "Complexes.h"
#include "Validators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using medial::AxisVertices;
using medial::FacePolygon;
using medial::Index;
using medial::None;
using medial::OpenSet;
using medial::Point;
using medial::SiteTriangulation;
using medial::VoronoiFaces;

namespace
{
/// The triangulation of random sites in a cube, with the centroids of the cells for their centres.
SiteTriangulation randomSites(std::mt19937& random, int siteCount)
{
  std::vector<Point> points;
  const auto coordinate = [&] { return static_cast<double>(random() % 1000000) / 1000000; };
  for (int i = 0; i < siteCount; ++i)
  {
    const double x = coordinate(), y = coordinate();
    points.push_back({ x, y, coordinate() });
  }
  SiteTriangulation sites;
  sites.mesh = medial::delaunay(points);
  sites.siteCount = siteCount;
  sites.edges = medial::edgeNumbers(sites.mesh.cells, siteCount);
  for (const medial::Tetrahedron& v : sites.mesh.cells)
  {
    const Point center = (points[v[0]] + points[v[1]] + points[v[2]] + points[v[3]]) / 4;
    sites.spheres.push_back({ center, 1 });
  }
  sites.onBall.assign(sites.mesh.cells.size(), None);
  return sites;
}

/// The cells around some points are on one ball each, whether they are a ball together or not.
void putOnBalls(std::mt19937& random, int ballCount, double share, SiteTriangulation& sites)
{
  std::vector<Point> centers;
  for (int b = 0; b < ballCount; ++b)
  {
    centers.push_back(sites.spheres[random() % sites.spheres.size()].center);
  }
  for (std::size_t c = 0; c < sites.onBall.size(); ++c)
  {
    const auto distance = [&](const Point& p) { return (p - sites.spheres[c].center).norm(); };
    const auto nearest = std::min_element(centers.begin(), centers.end(),
      [&](const Point& p, const Point& q) { return distance(p) < distance(q); });
    if (static_cast<double>(random() % 1000) < 1000 * share)
    {
      sites.onBall[c] = static_cast<Index>(nearest - centers.begin());
    }
  }
}

/// Of the faces and all dual vertices.
medial::Betti bettiNumbers(const VoronoiFaces& faces, const AxisVertices& vertices)
{
  validators::Complex complex = complexes::complexOf(faces.polygons);
  for (Index v = 0; v < medial::count(vertices.firstCell); ++v)
  {
    complex.vertices.push_back(v);
  }
  return validators::bettiNumbers(complex);
}
}

TEST(VoronoiFaces, HaveTheBettiNumbersOfTheirCellsWhateverIsOneVertex)
{
  int shared = 0, midpoints = 0;
  for (unsigned seed = 1; seed < 201; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    SiteTriangulation sites = randomSites(random, 40);
    putOnBalls(random, 1 + static_cast<int>(seed % 5), seed % 2 == 0 ? 1 : 0.7, sites);
    OpenSet set;
    for (std::size_t c = 0; c < sites.mesh.cells.size(); ++c)
    {
      set.cells.push_back(random() % 8 != 0);
    }
    const AxisVertices vertices = medial::axisVertices(sites, set);
    const VoronoiFaces faces = medial::voronoiFaces(sites, set, vertices);
    EXPECT_EQ(bettiNumbers(faces, vertices), medial::bettiNumbers(sites, set));
    const Index end = medial::count(vertices.firstCell) + medial::count(faces.midpoints);
    for (const FacePolygon& polygon : faces.polygons)
    {
      const std::set<Index> corners(polygon.corners.begin(), polygon.corners.end());
      EXPECT_EQ(corners.size(), polygon.corners.size());
      EXPECT_LT(*corners.rbegin(), end);
    }
    shared += medial::count(sites.mesh.cells) - medial::count(vertices.firstCell);
    midpoints += medial::count(faces.midpoints);
  }
  EXPECT_GT(shared, 10000);
  EXPECT_GT(midpoints, 1000);
}

TEST(AxisVertices, AreOneForTheCellsOfABallAndSeveralWhereTheyEncloseOthers)
{
  std::mt19937 random(5);
  SiteTriangulation sites = randomSites(random, 100);
  putOnBalls(random, 1, 1, sites);
  const OpenSet all{ std::vector<char>(sites.mesh.cells.size(), 1) };
  EXPECT_EQ(medial::axisVertices(sites, all).firstCell.size(), 1u);
  int voids = 0;
  for (Index site = 0; site < sites.siteCount; ++site)
  {
    OpenSet set = all;
    for (std::size_t c = 0; c < set.cells.size(); ++c)
    {
      const medial::Tetrahedron& corners = sites.mesh.cells[c];
      set.cells[c] = std::find(corners.begin(), corners.end(), site) == corners.end();
    }
    const AxisVertices around = medial::axisVertices(sites, set);
    EXPECT_EQ(around.ball, std::vector<Index>(around.firstCell.size(), 0));
    if (medial::bettiNumbers(sites, set) == medial::Betti{ 1, 0, 1 })
    {
      EXPECT_GT(around.firstCell.size(), 1u);
      ++voids;
    }
  }
  EXPECT_GT(voids, 0);
}
