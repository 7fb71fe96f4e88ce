// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelThickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace shapes
{
using medial::Point;

namespace
{
/// A cube of voxels.
class Grid
{
public:
  Grid(double half, double theStep)
    : size(static_cast<int>(std::ceil(2 * half / theStep)))
    , step(theStep)
  {
  }

  std::size_t total() const { return std::size_t(size) * size * size; }
  std::size_t number(int i, int j, int k) const { return (std::size_t(k) * size + j) * size + i; }
  Point centre(int i, int j, int k) const
  {
    return (Point(i, j, k) - Point::Constant((this->size - 1) / 2.0)) * this->step;
  }

  template <typename Body>
  void forAll(const Body& body) const
  {
    for (int k = 0; k < this->size; ++k)
    {
      for (int j = 0; j < this->size; ++j)
      {
        for (int i = 0; i < this->size; ++i)
        {
          body(i, j, k);
        }
      }
    }
  }

  int size;
  double step;
};

/// min over j of values[j] + (i - j)^2 for each i, in place: the lower envelope of parabolas.
void lowerEnvelope(std::vector<double>& values)
{
  const int size = static_cast<int>(values.size());
  std::vector<int> roots;
  std::vector<double> from;
  for (int q = 0; q < size; ++q)
  {
    if (values[q] == std::numeric_limits<double>::infinity())
    {
      continue;
    }
    double begin = -std::numeric_limits<double>::infinity();
    while (!roots.empty())
    {
      const int r = roots.back();
      begin = (values[q] + double(q) * q - values[r] - double(r) * r) / (2.0 * (q - r));
      if (begin > from.back())
      {
        break;
      }
      roots.pop_back();
      from.pop_back();
      begin = -std::numeric_limits<double>::infinity();
    }
    roots.push_back(q);
    from.push_back(begin);
  }
  std::vector<double> result(values.size(), std::numeric_limits<double>::infinity());
  std::size_t at = 0;
  for (int i = 0; i < size && !roots.empty(); ++i)
  {
    while (at + 1 < roots.size() && from[at + 1] < i)
    {
      ++at;
    }
    result[i] = values[roots[at]] + double(i - roots[at]) * (i - roots[at]);
  }
  values = result;
}

/// Squared distances, in voxels, from the centre of the nearest voxel outside.
std::vector<double> squaredDistances(const Grid& grid, const std::vector<char>& isInside)
{
  std::vector<double> result(grid.total());
  std::transform(isInside.begin(), isInside.end(), result.begin(),
    [](char inside) { return inside ? std::numeric_limits<double>::infinity() : 0; });
  std::vector<double> line(grid.size);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int a = 0; a < grid.size; ++a)
    {
      for (int b = 0; b < grid.size; ++b)
      {
        const auto number = [&](int i) {
          std::array<int, 3> place{ a, b, b };
          place[axis] = i;
          place[(axis + 1) % 3] = a;
          place[(axis + 2) % 3] = b;
          return grid.number(place[0], place[1], place[2]);
        };
        for (int i = 0; i < grid.size; ++i)
        {
          line[i] = result[number(i)];
        }
        lowerEnvelope(line);
        for (int i = 0; i < grid.size; ++i)
        {
          result[number(i)] = line[i];
        }
      }
    }
  }
  return result;
}

/// Is the ball of a voxel inside that of one of the voxels around it?
bool isCovered(const Grid& grid, const std::vector<double>& radii, const std::array<int, 3>& p)
{
  const double radius = radii[grid.number(p[0], p[1], p[2])];
  for (int n = 0; n < 27; ++n)
  {
    const int i = n % 3 - 1, j = n / 3 % 3 - 1, k = n / 9 - 1;
    const double other = radii[grid.number(p[0] + i, p[1] + j, p[2] + k)];
    if (n != 13 && other >= radius + std::sqrt(double(i * i + j * j + k * k)))
    {
      return true;
    }
  }
  return false;
}

/// For each voxel the radius, in voxels, of the largest ball around it. The solid doesn't touch the cube's faces.
std::vector<double> paintedRadii(const Grid& grid, const std::vector<double>& radii)
{
  std::vector<std::array<int, 3>> places;
  grid.forAll([&](int i, int j, int k) {
    if (radii[grid.number(i, j, k)] > 0 && !isCovered(grid, radii, { i, j, k }))
    {
      places.push_back({ i, j, k });
    }
  });
  const auto radiusAt = [&](const std::array<int, 3>& p) {
    return radii[grid.number(p[0], p[1], p[2])];
  };
  std::vector<double> result(grid.total(), 0);
  for (const std::array<int, 3>& p : places)
  {
    const double radius = radiusAt(p);
    const int reach = static_cast<int>(radius);
    for (int k = -reach; k <= reach; ++k)
    {
      for (int j = -reach; j <= reach; ++j)
      {
        for (int i = -reach; i <= reach; ++i)
        {
          // The ball's surface lies on the centre of an outer voxel: it isn't painted.
          if (i * i + j * j + k * k < radius * radius)
          {
            double& painted = result[grid.number(p[0] + i, p[1] + j, p[2] + k)];
            painted = std::max(painted, radius);
          }
        }
      }
    }
  }
  return result;
}
}

double voxelThickness(const std::function<bool(const Point&)>& isInside,
  const std::function<bool(const Point&)>& isCounted, double half, double step, double inward)
{
  const Grid grid(half, step);
  std::vector<char> inside(grid.total(), 0);
  grid.forAll([&](int i, int j, int k) {
    inside[grid.number(i, j, k)] = isInside(grid.centre(i, j, k)) ? 1 : 0;
  });
  std::vector<double> radii = squaredDistances(grid, inside);
  for (double& radius : radii)
  {
    radius = std::max(0.0, std::sqrt(radius) - inward);
  }
  const std::vector<double> painted = paintedRadii(grid, radii);
  double sum = 0;
  std::size_t number = 0;
  grid.forAll([&](int i, int j, int k) {
    if (inside[grid.number(i, j, k)] && isCounted(grid.centre(i, j, k)))
    {
      sum += painted[grid.number(i, j, k)];
      ++number;
    }
  });
  return 2 * step * sum / double(number);
}

double voxelThickness(const std::function<bool(const Point&)>& isInside,
  const std::function<bool(const Point&)>& isCounted, double half, double step)
{
  const auto both = [&](double side) {
    return (voxelThickness(isInside, isCounted, half, side, 0) +
             voxelThickness(isInside, isCounted, half, side, 0.5)) /
      2;
  };
  constexpr double finer = 0.7;
  const double coarse = both(step), fine = both(finer * step);
  return fine + (fine - coarse) * finer / (1 - finer);
}
}
