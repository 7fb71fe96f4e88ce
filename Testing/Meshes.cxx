// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"

#include "Numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace meshes
{
namespace
{
constexpr double pi = 3.14159265358979323846;

void append(Mesh& mesh, const std::vector<Index>& polygon)
{
  mesh.polygons.append(polygon);
}

using Cell = std::array<int, 3>;

/// Points at the corners of a grid, each made when first asked for.
class GridPoints
{
public:
  GridPoints(const std::array<std::vector<double>, 3>& theCuts, std::vector<Point>& thePoints)
    : cuts(theCuts)
    , points(thePoints)
  {
  }

  Index at(const Cell& corner)
  {
    const auto [found, isNew] = this->known.try_emplace(corner, medial::count(this->points));
    if (isNew)
    {
      this->points.emplace_back(
        this->cuts[0][corner[0]], this->cuts[1][corner[1]], this->cuts[2][corner[2]]);
    }
    return found->second;
  }

private:
  const std::array<std::vector<double>, 3>& cuts;
  std::vector<Point>& points;
  std::map<Cell, Index> known;
};

/// The side of a cell in the direction of an axis.
std::vector<Index> sideOf(const Cell& cell, int axis, bool above, GridPoints& points)
{
  std::vector<Index> result;
  for (const auto& [u, v] : { std::array{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
  {
    Cell corner = cell;
    corner[axis] += above;
    corner[(axis + 1) % 3] += u;
    corner[(axis + 2) % 3] += v;
    result.push_back(points.at(corner));
  }
  if (!above)
  {
    std::reverse(result.begin(), result.end());
  }
  return result;
}
}

Mesh blocks(const std::vector<double>& xs, const std::vector<double>& ys,
  const std::vector<double>& zs, const std::function<bool(int, int, int)>& filled)
{
  Mesh result;
  const std::array cuts{ xs, ys, zs };
  GridPoints points(cuts, result.points);
  const auto isFilled = [&](const Cell& cell) {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (cell[axis] < 0 || cell[axis] + 1 >= medial::count(cuts[axis]))
      {
        return false;
      }
    }
    return filled(cell[0], cell[1], cell[2]);
  };
  Cell cell{};
  for (cell[2] = 0; cell[2] + 1 < medial::count(zs); ++cell[2])
  {
    for (cell[1] = 0; cell[1] + 1 < medial::count(ys); ++cell[1])
    {
      for (cell[0] = 0; cell[0] + 1 < medial::count(xs); ++cell[0])
      {
        for (int side = 0; isFilled(cell) && side < 6; ++side)
        {
          const int axis = side / 2;
          const bool above = side % 2 == 1;
          Cell beside = cell;
          beside[axis] += above ? 1 : -1;
          if (!isFilled(beside))
          {
            append(result, sideOf(cell, axis, above, points));
          }
        }
      }
    }
  }
  return result;
}

Mesh box(const Point& low, const Point& high)
{
  return blocks({ low.x(), high.x() }, { low.y(), high.y() }, { low.z(), high.z() },
    [](int, int, int) { return true; });
}

Mesh drilledPlate(double thickness)
{
  return blocks({ 0, 1.5, 2.5, 4 }, { 0, 1.5, 2.5, 4 }, { 0, thickness },
    [](int i, int j, int) { return i != 1 || j != 1; });
}

Mesh iBeam(double length)
{
  return blocks({ 0, 1, 2, 3 }, { 0, 1, 2, 3 }, { 0, length },
    [](int i, int j, int) { return i == 1 || j != 1; });
}

Mesh tetrahedronWithFlatTriangle()
{
  Mesh result;
  result.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.5, 0, 0 } };
  append(result, { 1, 2, 3 });
  append(result, { 0, 3, 2 });
  append(result, { 0, 2, 1 });
  append(result, { 0, 4, 3 });
  append(result, { 4, 1, 3 });
  append(result, { 0, 1, 4 });
  return result;
}

Mesh torus(double large, double small, int around, int across)
{
  Mesh result;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2 * pi * i / around, v = 2 * pi * j / across;
      const double r = large + small * shapes::cosine(v);
      result.points.emplace_back(
        r * shapes::cosine(u), r * shapes::sine(u), small * shapes::sine(v));
    }
  }
  const auto at = [=](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      append(result, { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return result;
}

Mesh sphere(double radius, int around)
{
  Mesh result;
  const int rings = around / 2;
  for (int i = 1; i < rings; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const double u = pi * i / rings, v = 2 * pi * j / around;
      result.points.emplace_back(radius * shapes::sine(u) * shapes::cosine(v),
        radius * shapes::sine(u) * shapes::sine(v), radius * shapes::cosine(u));
    }
  }
  const Index top = medial::count(result.points), bottom = top + 1;
  result.points.emplace_back(0, 0, radius);
  result.points.emplace_back(0, 0, -radius);
  for (int j = 0; j < around; ++j)
  {
    const int next = (j + 1) % around, last = (rings - 2) * around;
    append(result, { top, j, next });
    for (int first = 0; first < last; first += around)
    {
      append(result, { first + j, first + around + j, first + around + next, first + next });
    }
    append(result, { last + j, bottom, last + next });
  }
  return result;
}

Mesh cylinder(double radius, double height, int around)
{
  Mesh result;
  std::vector<Index> floor, roof;
  for (int i = 0; i < around; ++i)
  {
    const double u = 2 * pi * i / around;
    result.points.emplace_back(radius * shapes::cosine(u), radius * shapes::sine(u), 0);
    result.points.emplace_back(radius * shapes::cosine(u), radius * shapes::sine(u), height);
    floor.push_back(2 * (around - 1 - i));
    roof.push_back(2 * i + 1);
    const int next = (i + 1) % around;
    append(result, { 2 * i, 2 * next, 2 * next + 1, 2 * i + 1 });
  }
  append(result, floor);
  append(result, roof);
  return result;
}

Mesh wedge(double degrees)
{
  Mesh result;
  const double rise = std::tan(degrees * pi / 180);
  result.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, rise, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, rise, 1 } };
  append(result, { 2, 1, 0 });
  append(result, { 3, 4, 5 });
  append(result, { 0, 1, 4, 3 });
  append(result, { 1, 2, 5, 4 });
  append(result, { 2, 0, 3, 5 });
  return result;
}

Mesh moved(Mesh mesh, const Point& by)
{
  for (Point& point : mesh.points)
  {
    point += by;
  }
  return mesh;
}

Mesh scaled(Mesh mesh, double factor)
{
  for (Point& point : mesh.points)
  {
    point *= factor;
  }
  return mesh;
}

Mesh reversed(const Mesh& mesh)
{
  Mesh result{ mesh.points, {} };
  for (Index i = 0; i < mesh.polygons.size(); ++i)
  {
    std::vector<Index> polygon(mesh.polygons[i].begin(), mesh.polygons[i].end());
    std::reverse(polygon.begin(), polygon.end());
    append(result, polygon);
  }
  return result;
}

Mesh united(const Mesh& a, const Mesh& b)
{
  Mesh result = a;
  result.points.insert(result.points.end(), b.points.begin(), b.points.end());
  for (Index i = 0; i < b.polygons.size(); ++i)
  {
    for (const Index p : b.polygons[i])
    {
      result.polygons.items.push_back(medial::count(a.points) + p);
    }
    result.polygons.close();
  }
  return result;
}

Mesh triangulated(const Mesh& mesh)
{
  Mesh result{ mesh.points, {} };
  for (Index i = 0; i < mesh.polygons.size(); ++i)
  {
    const IndexLists::View polygon = mesh.polygons[i];
    for (Index k = 2; k < polygon.size(); ++k)
    {
      append(result, { polygon[0], polygon[k - 1], polygon[k] });
    }
  }
  return result;
}

Mesh soup(const Mesh& mesh)
{
  Mesh result;
  for (Index i = 0; i < mesh.polygons.size(); ++i)
  {
    for (const Index p : mesh.polygons[i])
    {
      result.polygons.items.push_back(medial::count(result.points));
      result.points.push_back(mesh.points[p]);
    }
    result.polygons.close();
  }
  return result;
}

Mesh without(const Mesh& mesh, const std::function<bool(Index polygon)>& dropped)
{
  Mesh result{ mesh.points, {} };
  for (Index i = 0; i < mesh.polygons.size(); ++i)
  {
    if (!dropped(i))
    {
      result.polygons.append(mesh.polygons[i]);
    }
  }
  return result;
}

std::vector<Triangle> triangles(const Mesh& mesh)
{
  std::vector<Triangle> result;
  for (Index i = 0; i < mesh.polygons.size(); ++i)
  {
    const IndexLists::View polygon = mesh.polygons[i];
    result.push_back({ polygon[0], polygon[1], polygon[2] });
  }
  return result;
}
}
