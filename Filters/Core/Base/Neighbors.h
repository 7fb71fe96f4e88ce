// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Neighbors_h
#define medial_Neighbors_h

#include "Base/Execution.h"
#include "Base/Types.h"

#include <Eigen/Geometry>

#include <limits>
#include <vector>

namespace medial
{
/// Finds the nearest of a set of points. Built in O(n log n); a search takes O(k log n).
///
/// A k-d tree in two arrays. Each node knows the bounding box of its points: on a surface it is flat, and few boxes
/// are near to a place.
class Neighbors
{
public:
  /// @param points  are referred to
  explicit Neighbors(const std::vector<Point>& points);

  Index size() const { return count(this->points); }

  /// The other points nearest to a point, nearest first; fewer where there are not so many. Threads
  /// may search at the same time.
  std::vector<Index> nearest(Index point, Index howMany) const;

  /// The points nearest to a place, nearest first; fewer where there are not so many.
  std::vector<Index> nearest(const Point& place, Index howMany) const;

  /// The point nearest to a place; None if there is none nearer than that.
  Index nearestOne(
    const Point& place, double nearerThan = std::numeric_limits<double>::infinity()) const;

  /// The points, itself among them, that are at most so far from a point; in no particular order.
  std::vector<Index> within(Index point, double distance) const;

  /// The points that are at most so far from a place; in no particular order.
  std::vector<Index> within(const Point& place, double distance) const;

  /// Calls body(point) for each of them.
  template <typename Body>
  void forEachWithin(const Point& place, double distance, const Body& body) const;

  /// All points, near ones mostly after each other: in this order what a search needs is still in the cache.
  std::vector<Index> inOrder() const;

  /// The points that no search has taken yet.
  struct Left
  {
    std::vector<char> isHere;  ///< in the order of the tree
    std::vector<Index> inNode; ///< how many
  };

  /// All points.
  Left all() const;

  /// Calls body(point) for those that are left and at most so far from a place, and takes them. Where most are taken,
  /// a search is quick though many points are near.
  template <typename Body>
  void takeEachWithin(const Point& place, double distance, Left& left, const Body& body) const;

private:
  struct Numbered
  {
    Point place;
    Index number;
  };

  struct Node
  {
    Eigen::AlignedBox3d box;
    Index begin, end; ///< its points in `sorted`
    Index
      upper; ///< the child with the larger coordinates, the other one follows its parent; None: a leaf
    int axis; ///< along which its points are divided
  };

  static double squaredNorm(const Point& p)
  {
    return p.x() * p.x() + p.y() * p.y() + p.z() * p.z(); // in this order, Eigen's is another one
  }

  /// Not more than that of any point in the box: rounding is monotone.
  static double squaredDistance(const Eigen::AlignedBox3d& box, const Point& place)
  {
    return squaredNorm((box.min() - place).cwiseMax(place - box.max()).cwiseMax(0));
  }

  void build(Index begin, Index end, Eigen::AlignedBox3d cell);
  Index divide(const Node& node, const Eigen::AlignedBox3d& cell, double& cut, int& axis);

  /// Calls found(squaredDistance, point) for all points for which isNear(squaredDistance), which may become stricter; the
  /// near ones early.
  template <typename IsNear, typename Found>
  void search(Index node, const Point& place, const IsNear& isNear, const Found& found) const;

  /// @return  how many were taken of a node
  template <typename Body>
  Index take(Index node, const Point& place, double squared, Left& left, const Body& body) const;

  const std::vector<Point>& points;
  std::vector<Numbered> sorted; ///< those of a node follow each other
  std::vector<Node> nodes;      ///< the root first; none without points
};

/// Mean distance of each point from its six nearest; 0 where there is no other one.
/// @param neighbors  of the points
std::vector<double> meanDistances(
  const std::vector<Point>& points, const Neighbors& neighbors, const Execution& execution = {});

template <typename Body>
void Neighbors::forEachWithin(const Point& place, double distance, const Body& body) const
{
  if (!this->nodes.empty())
  {
    const double most = distance * distance;
    this->search(
      0, place, [most](double squared) { return squared <= most; },
      [&body](double, Index point) { body(point); });
  }
}

template <typename Body>
void Neighbors::takeEachWithin(
  const Point& place, double distance, Left& left, const Body& body) const
{
  if (!this->nodes.empty())
  {
    this->take(0, place, distance * distance, left, body);
  }
}

template <typename Body>
Index Neighbors::take(Index n, const Point& place, double most, Left& left, const Body& body) const
{
  const Node& node = this->nodes[n];
  if (left.inNode[n] == 0 || squaredDistance(node.box, place) > most)
  {
    return 0;
  }
  Index taken = 0;
  if (node.upper != None)
  {
    taken =
      this->take(n + 1, place, most, left, body) + this->take(node.upper, place, most, left, body);
  }
  else
  {
    for (Index i = node.begin; i < node.end; ++i)
    {
      if (left.isHere[i] && squaredNorm(this->sorted[i].place - place) <= most)
      {
        left.isHere[i] = 0;
        ++taken;
        body(this->sorted[i].number);
      }
    }
  }
  left.inNode[n] -= taken;
  return taken;
}

template <typename IsNear, typename Found>
void Neighbors::search(
  Index start, const Point& place, const IsNear& isNear, const Found& found) const
{
  Index n = start;
  while (this->nodes[n].upper != None)
  {
    const Index upper = this->nodes[n].upper;
    const int axis = this->nodes[n].axis;
    const double toUpper = place[axis] - this->nodes[upper].box.min()[axis];
    const double toLower = place[axis] - this->nodes[n + 1].box.max()[axis];
    const bool isLower = toUpper + toLower < 0;
    this->search(isLower ? n + 1 : upper, place, isNear, found);
    n = isLower ? upper : n + 1;
    if (!isNear(squaredDistance(this->nodes[n].box, place)))
    {
      return;
    }
  }
  for (Index i = this->nodes[n].begin; i < this->nodes[n].end; ++i)
  {
    const double squared = squaredNorm(this->sorted[i].place - place);
    if (isNear(squared))
    {
      found(squared, this->sorted[i].number);
    }
  }
}
}

#endif
