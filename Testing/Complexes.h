// SPDX-License-Identifier: BSD-3-Clause
#ifndef Complexes_h
#define Complexes_h

#include "Axis/FacePolygon.h"
#include "Axis/MedialAxis.h"
#include "Base/DisjointSets.h"
#include "Validators.h"

#include <algorithm>
#include <map>
#include <random>
#include <vector>

/// Small complexes made by hand, as medial axes: every point is a ball of radius 1 and volume 1,
/// every cell has its sites on the two sides. Nothing has burnt.
namespace complexes
{
using medial::AxisCells;
using medial::Edge;
using medial::Index;
using medial::MedialAxis;
using medial::None;
using medial::Point;
using medial::Triangle;

inline validators::Complex complexOf(const AxisCells& cells)
{
  return { cells.vertices, cells.edges, cells.triangles, {} };
}

/// Each face as a fan about a new vertex.
inline validators::Complex complexOf(const std::vector<medial::FacePolygon>& polygons)
{
  validators::Complex complex;
  Index apex = 1000000;
  for (const medial::FacePolygon& polygon : polygons)
  {
    const std::vector<Index>& c = polygon.corners;
    for (std::size_t i = 0; c.size() > 2 && i < c.size(); ++i)
    {
      complex.triangles.push_back({ apex, c[i], c[(i + 1) % c.size()] });
    }
    if (c.size() == 2)
    {
      complex.edges.push_back({ c[0], c[1] });
    }
    ++apex;
  }
  return complex;
}

inline medial::Betti bettiNumbers(const std::vector<medial::FacePolygon>& polygons)
{
  return validators::bettiNumbers(complexOf(polygons));
}

/// Each triangle and edge as one.
inline std::vector<medial::FacePolygon> polygonsOf(const AxisCells& cells)
{
  std::vector<medial::FacePolygon> result;
  for (const Triangle& t : cells.triangles)
  {
    result.push_back({ { t.begin(), t.end() }, None });
  }
  for (const Edge& edge : cells.edges)
  {
    result.push_back({ { edge.begin(), edge.end() }, None });
  }
  return result;
}

/// Groups of faces over the sides that exactly two of them have. Polygons of two corners don't count.
inline Index partCount(const std::vector<medial::FacePolygon>& polygons)
{
  std::map<Edge, std::vector<Index>> faces;
  Index result = 0;
  for (Index p = 0; p < medial::count(polygons); ++p)
  {
    const std::vector<Index>& c = polygons[p].corners;
    for (std::size_t i = 0; c.size() > 2 && i < c.size(); ++i)
    {
      const Index a = c[i], b = c[(i + 1) % c.size()];
      faces[{ std::min(a, b), std::max(a, b) }].push_back(p);
    }
    result += c.size() > 2;
  }
  medial::DisjointSets groups(medial::count(polygons));
  for (const auto& [side, at] : faces)
  {
    result -= at.size() == 2 && groups.unite(at[0], at[1]);
  }
  return result;
}

inline MedialAxis axisOf(std::vector<Point> points, AxisCells cells)
{
  MedialAxis axis;
  const std::size_t pointCount = points.size();
  axis.points = std::move(points);
  axis.radii.assign(pointCount, 1);
  for (Index i = 0; i < static_cast<Index>(pointCount); ++i)
  {
    axis.ballOfPoint.push_back(i);
    axis.ballOwner.push_back(i);
  }
  axis.ballVolumes.assign(pointCount, 1);
  axis.poleVolumes.assign(pointCount, 1);
  axis.cells = std::move(cells);
  axis.polygonOfCell.assign(static_cast<std::size_t>(axis.cells.size()), None);
  axis.samplesOfCell.assign(static_cast<std::size_t>(axis.cells.size()), Edge{ None, None });
  axis.siteViews.assign(static_cast<std::size_t>(axis.cells.size()), medial::SiteView{ 180, 2 });
  for (Index t = 0; t < medial::count(axis.cells.triangles); ++t)
  {
    axis.polygonOfCell[axis.cells.firstTriangle() + t] = t;
  }
  axis.erosion.assign(pointCount, 0);
  axis.cellErosion.assign(static_cast<std::size_t>(axis.cells.size()), 0);
  axis.betti = axis.powerShapeBetti = validators::bettiNumbers(complexOf(axis.cells));
  axis.certificate = true;
  axis.fallback = false;
  axis.kappa = 0;
  axis.filledGaps = 0;
  return axis;
}

/// Points by place, triangles by their corners: what a sheet is drawn with.
class Drawing
{
public:
  Index point(double x, double y, double z)
  {
    const Point place(x, y, z);
    const auto found = std::find(this->points.begin(), this->points.end(), place);
    if (found == this->points.end())
    {
      this->points.push_back(place);
      return medial::count(this->points) - 1;
    }
    return static_cast<Index>(found - this->points.begin());
  }

  void edge(Index a, Index b) { this->cells.edges.push_back({ a, b }); }
  void vertex(Index a) { this->cells.vertices.push_back(a); }
  void triangle(Index a, Index b, Index c) { this->cells.triangles.push_back({ a, b, c }); }

  /// A parallelogram of rows x columns x 2 triangles, spanned by two vectors.
  void sheet(const Point& corner, const Point& u, const Point& v, int rows, int columns)
  {
    const auto at = [&](int i, int j) {
      const Point place = corner + i * u + j * v;
      return this->point(place.x(), place.y(), place.z());
    };
    for (int i = 0; i < rows; ++i)
    {
      for (int j = 0; j < columns; ++j)
      {
        this->triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        this->triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }

  MedialAxis axis() const { return axisOf(this->points, this->cells); }

  std::vector<Point> points;
  AxisCells cells;
};

/// A box's faces as one closed sheet of that many squares in each direction.
inline Drawing closedSheet(int width)
{
  Drawing drawing;
  const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  for (const int side : { 0, width })
  {
    drawing.sheet(side * z, x, y, width, width);
    drawing.sheet(side * y, x, z, width, width);
    drawing.sheet(side * x, y, z, width, width);
  }
  return drawing;
}

/// Paper Figure 7, left: three sheets that meet along one line. The parts form a cycle but no loop.
inline Drawing cycleWithoutLoop()
{
  Drawing drawing;
  const Point up(0, 0, 1);
  drawing.sheet(Point(0, 0, 0), up, Point(1, 0, 0), 3, 3);
  drawing.sheet(Point(0, 0, 0), up, Point(0, 1, 0), 3, 3);
  drawing.sheet(Point(0, 0, 0), up, Point(-1, -1, 0), 3, 3);
  return drawing;
}

/// Paper Figure 7, right: three sheets round a triangular tunnel, each with a fin outside, so that
/// the sheets meet in pairs along three lines that don't touch. Parts 0, 1, 2 form the only loop;
/// parts 3, 4, 5 are the fins.
inline Drawing cycleWithLoop()
{
  Drawing drawing;
  const Point up(0, 0, 1);
  const Point a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  drawing.sheet(a, up, (b - a) / 4, 2, 4);
  drawing.sheet(b, up, (c - b) / 4, 2, 4);
  drawing.sheet(c, up, (a - c) / 4, 2, 4);
  drawing.sheet(a, up, Point(-1, -1, 0), 2, 1);
  drawing.sheet(b, up, Point(1, 0, 0), 2, 1);
  drawing.sheet(c, up, Point(0, 1, 0), 2, 1);
  return drawing;
}

/// A closed band round a tunnel with a larger fin outside. The loop is inside part 0, which touches
/// part 1 along one line.
inline Drawing bandWithFin()
{
  Drawing drawing;
  const Point up(0, 0, 1), corners[4] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } };
  for (int i = 0; i < 4; ++i)
  {
    drawing.sheet(corners[i], up, (corners[(i + 1) % 4] - corners[i]) / 2, 1, 2);
  }
  drawing.sheet(corners[0], up, Point(-1, -1, 0), 1, 20);
  return drawing;
}

/// Paper Figure 9, as a topology graph: four lines with a sheet between each two, which no other
/// touches. Sheets 0, 1, 2 run from the middle line outwards, 3, 4, 5 around them.
inline Drawing fourNodesAndSixParts()
{
  Drawing drawing;
  const Point up(0, 0, 1);
  const Point middle(1, 1, 0), corners[3] = { { -2, -2, 0 }, { 7, -2, 0 }, { -2, 7, 0 } };
  for (const Point& corner : corners)
  {
    drawing.sheet(middle, up, (corner - middle) / 3, 2, 3);
  }
  for (int i = 0; i < 3; ++i)
  {
    drawing.sheet(corners[i], up, (corners[(i + 1) % 3] - corners[i]) / 9, 2, 9);
  }
  return drawing;
}

/// Paper Figure 5: the exact axis of a box of 6 x 4 x 2. Each sheet is a fan about its centroid, cut
/// into triangles; `fins` more triangles stand on the middle sheet, each a sliver of its own.
inline Drawing boxAxis(int fins = 0)
{
  Drawing drawing;
  const auto polygon = [&drawing](const std::vector<Point>& corners) {
    Point centre = Point::Zero();
    for (const Point& corner : corners)
    {
      centre += corner / static_cast<double>(corners.size());
    }
    const Index apex = drawing.point(centre.x(), centre.y(), centre.z());
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      const Point &a = corners[k], &b = corners[(k + 1) % corners.size()];
      const Point middle = (a + b) / 2;
      const Index m = drawing.point(middle.x(), middle.y(), middle.z());
      drawing.triangle(apex, drawing.point(a.x(), a.y(), a.z()), m);
      drawing.triangle(apex, m, drawing.point(b.x(), b.y(), b.z()));
    }
  };
  const Point inner[4] = { { -2, -1, 0 }, { 2, -1, 0 }, { 2, 1, 0 }, { -2, 1, 0 } };
  const Point outer[4] = { { -3, -2, 1 }, { 3, -2, 1 }, { 3, 2, 1 }, { -3, 2, 1 } };
  const Point down(0, 0, -2);
  polygon({ inner[0], inner[1], inner[2], inner[3] });
  for (int i = 0; i < 4; ++i)
  {
    const int j = (i + 1) % 4;
    polygon({ inner[i], inner[j], outer[j], outer[i] });
    polygon({ inner[i], inner[j], outer[j] + down, outer[i] + down });
    polygon({ inner[i], outer[i], outer[i] + down });
  }
  for (int fin = 0; fin < fins; ++fin)
  {
    const Triangle foot = drawing.cells.triangles[fin % 8]; // of the middle sheet
    drawing.triangle(foot[0], foot[1], drawing.point(0.1 * fin, 0, 5));
  }
  return drawing;
}

/// A random complex without flat triangles: corners in general position on a moment curve. Some
/// of its triangles, edges and vertices lie in nothing else.
inline Drawing randomComplex(unsigned seed)
{
  std::mt19937 random(seed);
  const Index pointCount = 8 + static_cast<Index>(random() % 8);
  const Index triangleCount = 6 + static_cast<Index>(random() % 30);
  Drawing drawing;
  for (Index i = 0; i < pointCount; ++i)
  {
    const double t = 0.1 * i;
    drawing.point(t, t * t, t * t * t);
  }
  std::vector<std::vector<Index>> used;
  const auto isNew = [&used](std::vector<Index> corners) {
    std::sort(corners.begin(), corners.end());
    const bool distinct = std::adjacent_find(corners.begin(), corners.end()) == corners.end();
    const bool covered = std::any_of(used.begin(), used.end(), [&](const auto& other) {
      return std::includes(other.begin(), other.end(), corners.begin(), corners.end());
    });
    if (distinct && !covered)
    {
      used.push_back(corners);
    }
    return distinct && !covered;
  };
  const auto draw = [&] { return static_cast<Index>(random() % pointCount); };
  for (Index k = 0; k < triangleCount; ++k)
  {
    const Index a = draw(), b = draw(), c = draw();
    if (isNew({ a, b, c }))
    {
      drawing.triangle(a, b, c);
    }
  }
  for (Index k = 0; k < 6; ++k)
  {
    const Index a = draw(), b = draw();
    if (isNew({ a, b }))
    {
      drawing.edge(a, b);
    }
  }
  for (Index a = 0; a < pointCount; ++a)
  {
    if (isNew({ a }))
    {
      drawing.vertex(a);
    }
  }
  return drawing;
}
}

#endif
