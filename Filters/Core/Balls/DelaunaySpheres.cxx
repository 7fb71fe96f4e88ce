// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/DelaunaySpheres.h"

#include "Balls/DistinctSamples.h"
#include "Base/Predicates.h"
#include "Base/Triangulations.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

// On an exact sphere, box or grid very many samples are cospherical. The Delaunay triangulation cuts
// their common ball into many cells, whose circumspheres differ only by rounding error, and which of
// them exist is arbitrary. Unlike the paper, we therefore don't take each cell's sphere for a ball of
// its own: cells with the same sphere form a class, and a class gives one ball.
//
// Samples are known up to their precision, so that is how near all corners of a class must be to its
// sphere. Centres can't decide: where samples move by the precision, those of flat cells move far. The
// largest cell's sphere is the most certain one. A class begins with the largest cell that is in none, has
// its sphere, and grows over neighbours. A flat cell of four samples on one circle is on many spheres; it
// joins one class, and never connects two.
//
// With n samples this takes O(n log n) time for samples of a surface in practice: for the Delaunay
// triangulation and to sort the cells.
namespace medial
{
namespace
{
void measureCells(DelaunaySpheres& spheres, const Execution& execution)
{
  const Index cellCount = count(spheres.delaunay.cells);
  spheres.ballOfCell.resize(cellCount);
  spheres.cellVolumes.resize(cellCount);
  execution.forEach(cellCount, [&](Index c) {
    const Tetrahedron& v = spheres.delaunay.cells[c];
    const std::vector<Point>& p = spheres.points;
    const std::array<Point, 4> corners{ p[v[0]], p[v[1]], p[v[2]], p[v[3]] };
    spheres.ballOfCell[c] = circumsphere(corners, constructionError);
    spheres.cellVolumes[c] =
      std::abs(
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0])) /
      6;
  });
}

/// Are all corners of a cell on a sphere, as far as the precision of samples tells?
bool isOnSphere(const DelaunaySpheres& spheres, Index cell, const Ball& sphere)
{
  const Tetrahedron& corners = spheres.delaunay.cells[cell];
  const auto areWithin = [&](double reach) {
    return std::all_of(corners.begin(), corners.end(), [&](Index v) {
      return std::abs((spheres.points[v] - sphere.center).norm() - sphere.radius) <= reach;
    });
  };
  if (!areWithin(std::max(coincident, spheres.precision))) // as most are, however long their edges
  {
    return false;
  }
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [i, j] : cellEdges)
  {
    shortest = std::min(shortest, (spheres.points[corners[i]] - spheres.points[corners[j]]).norm());
  }
  const double reach = std::max(coincident, std::min(spheres.precision, leastPrecision * shortest));
  return areWithin(reach);
}

/// Gives the class of `seed` to all cells on its sphere that lead to it.
/// @param todo  space to work in
void growClass(const DelaunaySpheres& spheres, Index seed, std::vector<Index>& seedOfCell,
  std::vector<Index>& todo)
{
  seedOfCell[seed] = seed;
  todo.assign(1, seed);
  while (!todo.empty())
  {
    const Index c = todo.back();
    todo.pop_back();
    for (const Index n : spheres.delaunay.neighbors[c])
    {
      if (n != None && seedOfCell[n] == None && isOnSphere(spheres, n, spheres.ballOfCell[seed]))
      {
        seedOfCell[n] = seed;
        todo.push_back(n);
      }
    }
  }
}

/// Finds the classes; all cells of one take the sphere of its largest cell.
void findClasses(DelaunaySpheres& spheres, const Execution& execution)
{
  const Index cellCount = count(spheres.delaunay.cells);
  std::vector<Index> order(cellCount);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](Index a, Index b) { return spheres.cellVolumes[a] > spheres.cellVolumes[b]; });
  std::vector<Index> seedOfCell(cellCount, None), todo;
  for (const Index c : order)
  {
    execution.pollAt(c);
    if (seedOfCell[c] == None)
    {
      growClass(spheres, c, seedOfCell, todo);
    }
  }
  std::vector<Index> lowest(cellCount, None);
  const std::vector<Ball> own = spheres.ballOfCell;
  spheres.classOfCell.resize(cellCount);
  for (Index c = 0; c < cellCount; ++c)
  {
    Index& first = lowest[seedOfCell[c]];
    first = first == None ? c : first;
    spheres.classOfCell[c] = first;
    spheres.ballOfCell[c] = own[seedOfCell[c]];
  }
}

std::vector<double> nearestDistances(const DelaunaySpheres& spheres)
{
  // The nearest neighbour of a point is a Delaunay neighbour, so the edges of the cells are enough.
  std::vector<double> result(spheres.sampleCount, std::numeric_limits<double>::infinity());
  for (const Tetrahedron& cell : spheres.delaunay.cells)
  {
    for (const auto& [i, j] : cellEdges)
    {
      const Index a = cell[i], b = cell[j];
      if (a < spheres.sampleCount && b < spheres.sampleCount)
      {
        const double length = (spheres.points[a] - spheres.points[b]).norm();
        result[a] = length < coincident ? result[a] : std::min(result[a], length);
        result[b] = length < coincident ? result[b] : std::min(result[b], length);
      }
    }
  }
  return result;
}

double meanOfFinite(const std::vector<double>& values)
{
  double sum = 0;
  Index finite = 0;
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      sum += value;
      ++finite;
    }
  }
  return finite > 0 ? sum / finite : 0;
}
}

DelaunaySpheres delaunaySpheres(
  const std::vector<Point>& samples, double precision, const Execution& execution)
{
  DelaunaySpheres result;
  result.points = samples;
  result.sampleCount = count(samples);
  for (const Point& guard : guards(samples))
  {
    result.points.push_back(guard);
  }
  result.delaunay = delaunay(result.points, execution);
  result.nearest = nearestDistances(result);
  result.meanSpacing = meanOfFinite(result.nearest);
  result.precision = std::min(precision, leastPrecision * result.meanSpacing);
  measureCells(result, execution);
  findClasses(result, execution);
  return result;
}
}
