// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Parts/BallShares.h"
#include "Parts/MedialParts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

using complexes::Drawing;
using medial::ContactCurve;
using medial::Edge;
using medial::Index;
using medial::MedialAxis;
using medial::MedialPart;
using medial::MedialParts;
using medial::None;
using medial::Point;
using medial::Triangle;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
/// The parts of the triangles alone.
std::vector<Index> partOfTriangle(const MedialAxis& axis, const MedialParts& parts)
{
  return { parts.partOfCell.begin() + axis.cells.firstTriangle(), parts.partOfCell.end() };
}

/// For each edge of a triangle the parts of the triangles at it, one entry a triangle.
std::map<Edge, std::vector<Index>> partsAtEdges(const MedialAxis& axis, const MedialParts& parts)
{
  std::map<Edge, std::vector<Index>> result;
  for (Index t = 0; t < medial::count(axis.cells.triangles); ++t)
  {
    const Triangle& triangle = axis.cells.triangles[t];
    for (int i = 0; i < 3; ++i)
    {
      const Index a = triangle[i], b = triangle[(i + 1) % 3];
      result[{ std::min(a, b), std::max(a, b) }].push_back(
        parts.partOfCell[axis.cells.firstTriangle() + t]);
    }
  }
  return result;
}

double area(const MedialAxis& axis, const Triangle& t)
{
  const Point u = axis.points[t[1]] - axis.points[t[0]];
  const Point v = axis.points[t[2]] - axis.points[t[0]];
  return 0.5 * u.cross(v).norm();
}

std::set<Index> pointsOfPart(const MedialAxis& axis, const MedialParts& parts, Index part)
{
  std::set<Index> points;
  const medial::AxisCells& cells = axis.cells;
  for (Index cell = 0; cell < cells.size(); ++cell)
  {
    if (parts.partOfCell[cell] != part)
    {
      continue;
    }
    if (cell < cells.firstEdge())
    {
      points.insert(cells.vertices[cell]);
    }
    else if (cell < cells.firstTriangle())
    {
      const Edge& edge = cells.edges[cell - cells.firstEdge()];
      points.insert(edge.begin(), edge.end());
    }
    else
    {
      const Triangle& triangle = cells.triangles[cell - cells.firstTriangle()];
      points.insert(triangle.begin(), triangle.end());
    }
  }
  return points;
}
}

TEST(MedialParts, AreThoseOfAFloodFill)
{
  forEachShape([](Pipeline& p) {
    EXPECT_TRUE(validators::sameGroups(
      partOfTriangle(p.axis(), p.parts()), validators::floodFill(p.axis().cells.triangles)));
  });
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    EXPECT_TRUE(validators::sameGroups(
      partOfTriangle(axis, medial::decompose(axis)), validators::floodFill(axis.cells.triangles)));
  }
}

TEST(MedialParts, EveryCellIsInOneOfItsDimension)
{
  forEachShape([](Pipeline& p) {
    const MedialParts& parts = p.parts();
    const medial::AxisCells& cells = p.axis().cells;
    ASSERT_EQ(medial::count(parts.partOfCell), cells.size());
    std::vector<Index> size(parts.parts.size(), 0);
    for (Index cell = 0; cell < cells.size(); ++cell)
    {
      const int dimension = cell < cells.firstEdge() ? 0 : cell < cells.firstTriangle() ? 1 : 2;
      const MedialPart& part = parts.parts.at(static_cast<std::size_t>(parts.partOfCell[cell]));
      ASSERT_EQ(part.dimension, dimension) << "cell " << cell;
      ++size[parts.partOfCell[cell]];
    }
    for (Index i = 0; i < medial::count(parts.parts); ++i)
    {
      EXPECT_EQ(parts.value(medial::Measure::TriangleCount, i), size[i]);
    }
  });
}

TEST(MedialParts, AreNumberedByTheirLowestTriangle)
{
  forEachShape([](Pipeline& p) {
    Index highest = -1;
    for (const Index part : partOfTriangle(p.axis(), p.parts()))
    {
      ASSERT_LE(part, highest + 1);
      highest = std::max(highest, part);
    }
  });
}

TEST(MedialParts, AnEdgeWithTwoTrianglesIsInside)
{
  forEachShape([](Pipeline& p) {
    for (const auto& [edge, parts] : partsAtEdges(p.axis(), p.parts()))
    {
      ASSERT_TRUE(parts.size() != 2 || parts[0] == parts[1]);
    }
  });
}

TEST(MedialParts, LevelsCountFromTheBorder)
{
  const auto expectLevels = [](const MedialAxis& axis, const MedialParts& parts) {
    const std::vector<Index> labels = partOfTriangle(axis, parts);
    const std::vector<int> levels = validators::levels(axis.cells.triangles, labels);
    for (std::size_t part = 0; part < levels.size(); ++part)
    {
      EXPECT_EQ(parts.parts[part].level, levels[part]) << "part " << part;
    }
  };
  forEachShape([&](Pipeline& p) { expectLevels(p.axis(), p.parts()); });
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    expectLevels(axis, medial::decompose(axis));
  }
}

TEST(MedialParts, OfLevelITouchOneOfLevelIMinusOne)
{
  forEachShape([](Pipeline& p) {
    std::map<Index, int> lowest; // level among the neighbours
    for (const auto& [edge, parts] : partsAtEdges(p.axis(), p.parts()))
    {
      for (const Index a : parts)
      {
        for (const Index b : parts)
        {
          const int level = p.parts().parts[b].level;
          if (a != b && level > 0)
          {
            const int before = lowest.emplace(a, level).first->second;
            lowest[a] = std::min(before, level);
          }
        }
      }
    }
    for (std::size_t i = 0; i < p.parts().parts.size(); ++i)
    {
      const MedialPart& part = p.parts().parts[i];
      if (part.dimension == 2 && part.level > 1)
      {
        EXPECT_EQ(lowest[static_cast<Index>(i)], part.level - 1);
      }
    }
  });
}

TEST(MedialParts, RelativeVolumesSumToOne)
{
  forEachShape([](Pipeline& p) {
    double relative = 0, absolute = 0;
    for (Index i = 0; i < medial::count(p.parts().parts); ++i)
    {
      EXPECT_GE(p.parts().parts[i].volume, 0);
      relative += p.parts().value(medial::Measure::RelativeVolume, i);
      absolute += p.parts().parts[i].volume;
    }
    const std::vector<double>& volumes = p.axis().ballVolumes;
    EXPECT_NEAR(relative, 1, 1e-9);
    EXPECT_NEAR(absolute / std::accumulate(volumes.begin(), volumes.end(), 0.0), 1, 1e-9);
  });
}

TEST(MedialParts, OfABallHasMostOfTheCellsThere)
{
  forEachShape([](Pipeline& p) {
    const std::vector<Index> partOfBall = medial::partOfBall(p.axis(), p.parts().partOfCell);
    std::vector<std::set<Index>> points;
    for (Index part = 0; part < medial::count(p.parts().parts); ++part)
    {
      points.push_back(pointsOfPart(p.axis(), p.parts(), part));
    }
    for (Index i = 0; i < medial::count(p.axis().points); ++i)
    {
      const Index ball = p.axis().ballOfPoint[i];
      if (ball != None)
      {
        EXPECT_EQ(points[partOfBall[ball]].count(i), 1u) << "point " << i;
      }
    }
  });
}

TEST(MedialParts, MeasuresAreThoseOfTheirCells)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis& axis = p.axis();
    std::vector<double> areas(p.parts().parts.size(), 0);
    for (Index t = 0; t < medial::count(axis.cells.triangles); ++t)
    {
      areas[p.parts().partOfCell[axis.cells.firstTriangle() + t]] +=
        area(axis, axis.cells.triangles[t]);
    }
    for (Index i = 0; i < medial::count(p.parts().parts); ++i)
    {
      const MedialPart& part = p.parts().parts[i];
      EXPECT_NEAR(
        p.parts().value(medial::Measure::Area, i), areas[i], 1e-9 * p.diagonal * p.diagonal);
      const std::set<Index> points = pointsOfPart(axis, p.parts(), i);
      Point lower = axis.points[*points.begin()], upper = lower;
      double least = INFINITY, most = 0, sum = 0;
      for (const Index point : points)
      {
        lower = lower.cwiseMin(axis.points[point]);
        upper = upper.cwiseMax(axis.points[point]);
        least = std::min(least, axis.radii[point]);
        most = std::max(most, axis.radii[point]);
        sum += axis.radii[point];
      }
      EXPECT_EQ(part.lower, lower);
      EXPECT_EQ(part.upper, upper);
      EXPECT_EQ(part.minimumRadius, least);
      EXPECT_EQ(p.parts().value(medial::Measure::MaximumRadius, i), most);
      EXPECT_NEAR(
        p.parts().value(medial::Measure::MeanRadius, i), sum / points.size(), 1e-9 * p.diagonal);
    }
  });
}

TEST(MedialParts, ContactsAreUnbrokenPolylines)
{
  forEachShape([](Pipeline& p) {
    const auto atEdges = partsAtEdges(p.axis(), p.parts());
    std::set<Edge> seen;
    for (const ContactCurve& curve : p.parts().contacts)
    {
      EXPECT_TRUE(std::is_sorted(curve.parts.begin(), curve.parts.end(), std::less_equal<>()));
      for (std::size_t i = 1; i < curve.points.size(); ++i)
      {
        const Edge edge{ std::min(curve.points[i - 1], curve.points[i]),
          std::max(curve.points[i - 1], curve.points[i]) };
        ASSERT_TRUE(seen.insert(edge).second) << "an edge in two curves";
        const auto found = atEdges.find(edge);
        ASSERT_NE(found, atEdges.end());
        const std::set<Index> parts(found->second.begin(), found->second.end());
        EXPECT_EQ(std::vector<Index>(parts.begin(), parts.end()), curve.parts);
      }
    }
    for (const auto& [edge, parts] : atEdges)
    {
      const bool touching = std::set<Index>(parts.begin(), parts.end()).size() > 1;
      EXPECT_TRUE(!touching || seen.count(edge) == 1) << "a contact edge in no curve";
    }
  });
}

TEST(MedialParts, CountTheirContacts)
{
  forEachShape([](Pipeline& p) {
    std::vector<Index> contacts(p.parts().parts.size(), 0);
    for (const ContactCurve& curve : p.parts().contacts)
    {
      for (const Index part : curve.parts)
      {
        ++contacts[part];
      }
    }
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
      EXPECT_EQ(p.parts().parts[i].contacts, contacts[i]) << "part " << i;
    }
  });
}

TEST(MedialParts, TouchWhereverTheyShareAPoint)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    const MedialParts parts = medial::decompose(axis);
    std::map<Index, std::set<Index>> sharing, touching; // by point
    for (Index part = 0; part < medial::count(parts.parts); ++part)
    {
      for (const Index p : pointsOfPart(axis, parts, part))
      {
        sharing[p].insert(part);
      }
    }
    for (const ContactCurve& curve : parts.contacts)
    {
      for (const Index p : curve.points)
      {
        touching[p].insert(curve.parts.begin(), curve.parts.end());
      }
    }
    for (const auto& [point, there] : sharing)
    {
      EXPECT_TRUE(there.size() < 2 || touching[point] == there) << "point " << point;
    }
  }
}

TEST(MedialParts, CentroidsAreThoseOfTheirArea)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 3, 0), 1, 1);
  drawing.sheet(
    Point(1, 0, 0), Point(0.5, 0, 0), Point(0, 1, 0), 6, 3); // not joined: other corners
  const Index a = drawing.point(9, 0, 0), b = drawing.point(9, 1, 0);
  drawing.edge(a, b);
  drawing.edge(b, drawing.point(9, 5, 0));
  drawing.vertex(drawing.point(7, 7, 7));
  const MedialParts parts = medial::decompose(drawing.axis());
  ASSERT_EQ(parts.parts.size(), 4u);
  EXPECT_TRUE(parts.parts[0].centroid.isApprox(Point(0.5, 1.5, 0)));
  EXPECT_TRUE(parts.parts[1].centroid.isApprox(Point(2.5, 1.5, 0)));
  EXPECT_TRUE(parts.parts[2].centroid.isApprox(Point(9, 2.5, 0)));
  EXPECT_EQ(parts.parts[3].centroid, Point(7, 7, 7));
}

TEST(MedialParts, AreTheSameOnManyThreads)
{
  Pipeline& p = pipelines::of("box");
  EXPECT_EQ(pipelines::bytesOf(medial::decompose(p.axis(), 0, pipelines::threaded())),
    pipelines::bytesOf(p.parts()));
}
