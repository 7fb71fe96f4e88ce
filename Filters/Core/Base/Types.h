// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Types_h
#define medial_Types_h

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

/// The medial axis of a solid given by points of its boundary, its parts, their pruning, and the
/// way back to a surface. Plain C++: values in, values out, exceptions for what can't be done.
namespace medial
{
/// Number of a sample, ball, cell, ...: an index into the array that holds it.
using Index = std::int32_t;

/// "No such thing" where an Index is expected.
constexpr Index None = -1;

using Point = Eigen::Vector3d;

struct Ball
{
  Point center;
  double radius;
};

/// How deeply two balls intersect, as the cosine of the angle at which their spheres do: 1 for the same
/// sphere, 0 where they are orthogonal, negative where they barely meet.
inline double intersectionDepth(const Ball& a, const Ball& b)
{
  return (a.radius * a.radius + b.radius * b.radius - (a.center - b.center).squaredNorm()) /
    (2 * a.radius * b.radius);
}

/// How opposite two balls are, seen from a point: minus the cosine of the angle between the directions to
/// their centres, 1 in opposite directions.
inline double opposition(const Point& point, const Ball& a, const Ball& b)
{
  const Point u = a.center - point, v = b.center - point;
  return -u.normalized().dot(v.normalized());
}

/// Where a ball lies: outside or inside the solid, or hidden (it has no cell in the power diagram).
enum class Side : signed char
{
  Outer = 0,
  Inner = 1,
  Hidden = 2
};

/// Betti numbers over Z/2: connected pieces, tunnels, enclosed voids.
using Betti = std::array<Index, 3>;

/// By how much two solids' Betti numbers differ: the sum of the three differences.
inline Index bettiDistance(const Betti& a, const Betti& b)
{
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

using Edge = std::array<Index, 2>;
using Triangle = std::array<Index, 3>;
using Tetrahedron = std::array<Index, 4>;

/// Number of elements of a container, as an Index.
template <typename Container>
Index count(const Container& container)
{
  return static_cast<Index>(container.size());
}
}

#endif
