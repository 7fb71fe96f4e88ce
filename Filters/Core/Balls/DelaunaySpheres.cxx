// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/DelaunaySpheres.h"

#include "Balls/DistinctSamples.h"
#include "Base/DisjointSets.h"
#include "Base/Predicates.h"
#include "Base/Triangulations.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

// On an exact sphere, box or grid very many samples are cospherical. The Delaunay triangulation cuts
// their common ball into many cells, whose circumspheres differ only by rounding error, and which of
// them exist is arbitrary. Unlike the paper, we therefore don't take each cell's sphere for a ball of
// its own: cells with the same sphere form a class, and a class gives one ball.
//
// Two adjacent cells are in one class where their centres are closer than `coincident`; classes are
// the connected components of this relation. The corners of all cells of a class are on its sphere.
// With n samples this takes the time of the Delaunay triangulation, O(n log n) for samples of a
// surface in practice, and nearly linear time for the classes.
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

void findClasses(DelaunaySpheres& spheres)
{
  const Index cellCount = count(spheres.delaunay.cells);
  DisjointSets classes(cellCount);
  for (Index c = 0; c < cellCount; ++c)
  {
    for (const Index n : spheres.delaunay.neighbors[c])
    {
      if (n > c &&
        (spheres.ballOfCell[c].center - spheres.ballOfCell[n].center).norm() < coincident)
      {
        classes.unite(c, n);
      }
    }
  }
  spheres.classOfCell.resize(cellCount);
  for (Index c = 0; c < cellCount; ++c)
  {
    spheres.classOfCell[c] = classes.find(c);
  }
}

/// All cells of a class take the sphere of its cell of largest volume. The flatter a cell, the larger
/// the error of its centre.
void shareBalls(DelaunaySpheres& spheres)
{
  std::vector<Index> best(spheres.ballOfCell.size(), None);
  for (Index c = 0; c < count(best); ++c)
  {
    Index& chosen = best[spheres.classOfCell[c]];
    if (chosen == None || spheres.cellVolumes[c] > spheres.cellVolumes[chosen])
    {
      chosen = c;
    }
  }
  const std::vector<Ball> own = spheres.ballOfCell;
  for (Index c = 0; c < count(best); ++c)
  {
    spheres.ballOfCell[c] = own[best[spheres.classOfCell[c]]];
  }
}
}

DelaunaySpheres delaunaySpheres(const std::vector<Point>& samples, const Execution& execution)
{
  DelaunaySpheres result;
  result.points = samples;
  result.sampleCount = count(samples);
  for (const Point& guard : guards(samples))
  {
    result.points.push_back(guard);
  }
  result.delaunay = delaunay(result.points, execution);
  measureCells(result, execution);
  findClasses(result);
  shareBalls(result);
  return result;
}

double meanSpacing(const DelaunaySpheres& spheres)
{
  // The nearest neighbour of a point is a Delaunay neighbour, so the edges of the cells are enough.
  std::vector<double> shortest(spheres.sampleCount, std::numeric_limits<double>::infinity());
  for (const Tetrahedron& cell : spheres.delaunay.cells)
  {
    for (const auto& [i, j] : cellEdges)
    {
      const Index a = cell[i], b = cell[j];
      if (a < spheres.sampleCount && b < spheres.sampleCount)
      {
        const double length = (spheres.points[a] - spheres.points[b]).norm();
        shortest[a] = length < coincident ? shortest[a] : std::min(shortest[a], length);
        shortest[b] = length < coincident ? shortest[b] : std::min(shortest[b], length);
      }
    }
  }
  double sum = 0;
  Index finite = 0;
  for (const double length : shortest)
  {
    if (std::isfinite(length))
    {
      sum += length;
      ++finite;
    }
  }
  return finite > 0 ? sum / finite : 0;
}
}
