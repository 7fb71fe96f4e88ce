// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Types_h
#define medial_Types_h

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <numeric>
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

/// Where a ball lies: outside or inside the solid, or hidden (it has no cell in the power diagram).
enum class Side : signed char
{
  Outer = 0,
  Inner = 1,
  Hidden = 2
};

/// Betti numbers over Z/2: connected pieces, tunnels, enclosed voids.
using Betti = std::array<Index, 3>;

using Edge = std::array<Index, 2>;
using Triangle = std::array<Index, 3>;
using Tetrahedron = std::array<Index, 4>;

/// A list of lists of indices, flat: list i is items[offsets[i]] ... items[offsets[i + 1] - 1].
struct IndexLists
{
  std::vector<Index> offsets{ 0 };
  std::vector<Index> items;

  /// One list, to be walked in a range-for.
  struct View
  {
    const Index* first;
    const Index* last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    Index size() const { return static_cast<Index>(last - first); }
    Index operator[](Index i) const { return first[i]; }
  };

  Index size() const { return static_cast<Index>(offsets.size()) - 1; }
  View operator[](Index i) const
  {
    return { items.data() + offsets[i], items.data() + offsets[i + 1] };
  }
  /// Ends the list that was being appended to `items`.
  void close() { offsets.push_back(static_cast<Index>(items.size())); }
};

/// Number of elements of a container, as an Index.
template <typename Container>
Index count(const Container& container)
{
  return static_cast<Index>(container.size());
}

/// List k holds the values that come with the key k, in their order.
/// @param forAll  calls its argument(key, value) for all of them, the same each time
template <typename ForAll>
IndexLists listsByKey(Index keyCount, const ForAll& forAll)
{
  IndexLists result;
  result.offsets.assign(keyCount + 1, 0);
  forAll([&result](Index key, Index) { ++result.offsets[key + 1]; });
  std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  result.items.resize(result.offsets.back());
  std::vector<Index> next = result.offsets;
  forAll([&](Index key, Index value) { result.items[next[key]++] = value; });
  return result;
}
}

#endif
