// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/CrowdedPoles.h"

#include <algorithm>
#include <cmath>

// The largest pole begins a crowd, which grows over neighbouring cells: edges of the Voronoi diagram join vertices
// that crowd, so nothing has to be searched for. Cells of poles that another one stands for are not entered again.
namespace medial
{
namespace
{
class Crowds
{
public:
  Crowds(const DelaunaySpheres& theSpheres, const Poles& poles)
    : spheres(theSpheres)
    , standing(polesAlone(poles))
    , stands(this->standing.size(), 0)
    , cellCount(this->standing.size(), 0)
    , foundCount(this->standing.size(), 0)
    , foundBy(this->standing.size(), None)
  {
    for (const Index itsClass : theSpheres.classOfCell)
    {
      ++this->cellCount[itsClass];
    }
  }

  std::vector<Index> run()
  {
    std::vector<Index> order;
    for (const Index pole : this->standing)
    {
      pole == None ? void() : order.push_back(pole);
    }
    std::stable_sort(order.begin(), order.end(), [this](Index a, Index b) {
      return this->spheres.ballOfCell[a].radius > this->spheres.ballOfCell[b].radius;
    });
    for (const Index pole : order)
    {
      if (this->standing[pole] == pole)
      {
        this->standForCrowd(pole);
      }
    }
    return std::move(this->standing);
  }

private:
  void standForCrowd(Index pole)
  {
    constexpr Index fewest = 15; // fewer don't cost much, and other shapes have so few at most
    this->findCells(pole);
    std::vector<Index> others; // poles all of whose cells are found
    for (const Index cell : this->found)
    {
      const Index other = this->spheres.classOfCell[cell];
      if (++this->foundCount[other] == this->cellCount[other] && other != pole &&
        this->standing[other] != None && !this->stands[other])
      {
        others.push_back(other);
      }
    }
    for (const Index cell : this->found)
    {
      this->foundCount[this->spheres.classOfCell[cell]] = 0;
    }
    if (count(others) >= fewest)
    {
      this->stands[pole] = 1;
      for (const Index other : others)
      {
        this->standing[other] = pole;
      }
    }
  }

  void findCells(Index pole)
  {
    this->found.assign(1, pole);
    this->foundBy[pole] = pole;
    for (std::size_t i = 0; i < this->found.size(); ++i)
    {
      for (const Index next : this->spheres.delaunay.neighbors[this->found[i]])
      {
        if (next != None && this->foundBy[next] != pole && this->isFree(next) &&
          this->isLike(next, this->spheres.ballOfCell[pole]))
        {
          this->foundBy[next] = pole;
          this->found.push_back(next);
        }
      }
    }
  }

  bool isFree(Index cell) const
  {
    const Index itsClass = this->spheres.classOfCell[cell];
    return this->standing[itsClass] == None || this->standing[itsClass] == itsClass;
  }

  /// Is its sphere so similar to the ball that this can stand for it?
  bool isLike(Index cell, const Ball& ball) const
  {
    // The two poles of a sample are farther apart than either radius, so that no ball stands for both.
    constexpr double ofSpacing = 0.5, ofRadius = 0.25;
    const double apart = (this->spheres.ballOfCell[cell].center - ball.center).norm();
    const Tetrahedron& corners = this->spheres.delaunay.cells[cell];
    return apart < ofRadius * ball.radius &&
      std::all_of(corners.begin(), corners.end(), [&](Index v) {
        return v < this->spheres.sampleCount && apart < ofSpacing * this->spheres.nearest[v] &&
          std::abs((this->spheres.points[v] - ball.center).norm() - ball.radius) <
          crowdPrecision * this->spheres.nearest[v];
      });
  }

  const DelaunaySpheres& spheres;
  std::vector<Index> standing;
  std::vector<char> stands;                 ///< for each class: does its pole stand for others?
  std::vector<Index> cellCount, foundCount; ///< of each class; all, and while a crowd is counted
  std::vector<Index> foundBy; ///< for each cell the last pole whose crowd it was found for
  std::vector<Index> found;
};
}

std::vector<Index> standingPoles(const DelaunaySpheres& spheres, const Poles& poles)
{
  return Crowds(spheres, poles).run();
}

std::vector<Index> polesAlone(const Poles& poles)
{
  std::vector<Index> result(poles.isPole.size());
  for (Index c = 0; c < count(result); ++c)
  {
    result[c] = poles.isPole[c] ? c : None;
  }
  return result;
}
}
