// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SharpEdges.h"

#include "Base/Lists.h"
#include "Base/Neighbors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace medial
{
namespace
{
double cosineOf(double degrees)
{
  return std::cos(degrees * 3.14159265358979323846 / 180);
}

/// All edges between two triangles the cosine of whose normals is below one and above the other, in the order
/// of their ends.
std::vector<SharpEdge> sharpEdges(const TriangleSet& surface, double cosine, double least)
{
  struct Side
  {
    Edge sorted;
    Index triangle;
    int corner;
  };
  std::vector<Side> sides;
  for (Index t = 0; t < count(surface.triangles); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index a = surface.triangles[t][k], b = surface.triangles[t][(k + 1) % 3];
      sides.push_back({ { std::min(a, b), std::max(a, b) }, t, k });
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.triangle < b.triangle;
  });
  std::vector<SharpEdge> result;
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    const Side &first = sides[i - 1], &second = sides[i];
    const double along = surface.normals[first.triangle].dot(surface.normals[second.triangle]);
    if (first.sorted == second.sorted && surface.areas[first.triangle] > 0 &&
      surface.areas[second.triangle] > 0 && along < cosine && along > least)
    {
      const Triangle& t = surface.triangles[first.triangle];
      result.push_back(
        { { t[first.corner], t[(first.corner + 1) % 3] }, { first.triangle, second.triangle } });
    }
  }
  return result;
}

SharpEdge reversed(const SharpEdge& edge)
{
  return { { edge.ends[1], edge.ends[0] }, { edge.triangles[1], edge.triangles[0] } };
}

/// Follows sharp edges from point to point.
class Follower
{
public:
  Follower(const TriangleSet& theSurface, std::vector<SharpEdge> theEdges, double theCosine)
    : surface(theSurface)
    , edges(std::move(theEdges))
    , cosine(theCosine)
    , done(edges.size(), 0)
    , edgesAt(listsByKey(count(theSurface.points), [this](const auto& add) {
      for (Index e = 0; e < count(this->edges); ++e)
      {
        add(this->edges[e].ends[0], e);
        add(this->edges[e].ends[1], e);
      }
    }))
  {
  }

  std::vector<SharpLine> lines()
  {
    std::vector<SharpLine> result;
    for (int loops = 0; loops < 2; ++loops) // first those that end somewhere
    {
      for (Index e = 0; e < count(this->edges); ++e)
      {
        for (const SharpEdge& begin : { this->edges[e], reversed(this->edges[e]) })
        {
          if (!this->done[e] && (loops > 0 || !this->next(reversed(begin))))
          {
            result.push_back(this->follow(e, begin));
          }
        }
      }
    }
    return result;
  }

private:
  SharpLine follow(Index e, SharpEdge edge)
  {
    SharpLine line{ edge };
    this->done[e] = 1;
    for (auto following = this->next(edge); following && !this->done[*following];
         following = this->next(edge))
    {
      const SharpEdge& found = this->edges[*following];
      this->done[*following] = 1;
      edge = found.ends[0] == edge.ends[1] ? found : reversed(found);
      line.push_back(edge);
    }
    return line;
  }

  Point direction(const Edge& ends) const
  {
    return (this->surface.points[ends[1]] - this->surface.points[ends[0]]).normalized();
  }

  /// The edge that goes on straight where `edge` ends, if it is the only other one there.
  std::optional<Index> next(const SharpEdge& edge) const
  {
    const auto here = this->edgesAt[edge.ends[1]];
    if (here.size() != 2)
    {
      return {};
    }
    for (const Index e : here)
    {
      const Edge& ends = this->edges[e].ends;
      const bool same = std::minmax(ends[0], ends[1]) == std::minmax(edge.ends[0], edge.ends[1]);
      const Edge onwards = ends[0] == edge.ends[1] ? ends : Edge{ ends[1], ends[0] };
      if (!same && this->direction(edge.ends).dot(this->direction(onwards)) > this->cosine)
      {
        return e;
      }
    }
    return {};
  }

  const TriangleSet& surface;
  std::vector<SharpEdge> edges;
  double cosine;
  std::vector<char> done;
  IndexLists edgesAt;
};

/// A place on a line.
struct LinePlace
{
  Point point;
  const SharpEdge* edge;
};

/// Shorter lines are noise of a scan; in spacings.
constexpr double shortest = 3;

/// Places along a line, about as far apart as the spacing; half of that from its ends where it ends.
std::vector<LinePlace> placesOn(
  const SharpLine& line, const TriangleSet& surface, const SpacingField& spacing)
{
  const auto at = [&surface](Index p) -> const Point& { return surface.points[p]; };
  // How many spacings long: the places are at 1/2, 3/2, 5/2 ... of equal shares of it.
  std::vector<double> lengths{ 0 };
  for (const SharpEdge& edge : line)
  {
    const double length = (at(edge.ends[1]) - at(edge.ends[0])).norm();
    const auto pieces =
      static_cast<int>(std::clamp(std::ceil(length / spacing.at(at(edge.ends[0]))), 1.0, 1e4));
    double sum = 0;
    for (int i = 0; i < pieces; ++i)
    {
      const double t = (i + 0.5) / pieces;
      sum += length / pieces / spacing.at((1 - t) * at(edge.ends[0]) + t * at(edge.ends[1]));
    }
    lengths.push_back(lengths.back() + sum);
  }
  std::vector<LinePlace> result;
  if (lengths.back() < shortest)
  {
    return result;
  }
  const auto shares = static_cast<int>(std::round(lengths.back()));
  std::size_t e = 0;
  for (int i = 0; i < shares; ++i)
  {
    const double s = (i + 0.5) * lengths.back() / shares;
    while (e + 1 < line.size() && lengths[e + 1] < s)
    {
      ++e;
    }
    const double t = (s - lengths[e]) / (lengths[e + 1] - lengths[e]);
    const Edge& ends = line[e].ends;
    result.push_back({ (1 - t) * at(ends[0]) + t * at(ends[1]), &line[e] });
  }
  return result;
}

/// How many rows of pairs the narrowest wedge of a line has.
int rowsOf(const SharpLine& line, const TriangleSet& surface)
{
  double cosine = -1; // of the angle between the walls
  for (const SharpEdge& edge : line)
  {
    cosine =
      std::max(cosine, -surface.normals[edge.triangles[0]].dot(surface.normals[edge.triangles[1]]));
  }
  // A wedge is two spacings thick as many spacings from its edge.
  constexpr double most = 38; // three degrees: narrower wedges are sampled as densely as thin walls
  return static_cast<int>(
    std::clamp(std::sqrt((1 + cosine) / std::max(1 - cosine, 1e-9)), 1.0, most));
}

/// The samples on both sides of a place on an edge, if both faces have room for them.
std::optional<std::array<SurfacePoint, 2>> pairAt(
  const LinePlace& place, const TriangleSet& surface, const SurfaceTree& tree, double distance)
{
  const Point along =
    (surface.points[place.edge->ends[1]] - surface.points[place.edge->ends[0]]).normalized();
  std::array<SurfacePoint, 2> result;
  for (int k = 0; k < 2; ++k)
  {
    const Point& normal = surface.normals[place.edge->triangles[k]];
    const Point wanted = place.point + distance * normal.cross(k == 0 ? along : Point(-along));
    const SurfaceTree::Place found = tree.nearest(wanted);
    const Point& there = surface.normals[found.triangle];
    constexpr double off = 0.05;      // of the distance: the face is flat that far
    constexpr double parallel = 0.98; // cosine: and still the same one
    if ((found.point - wanted).norm() > off * distance || normal.dot(there) < parallel)
    {
      return {};
    }
    result[k] = { found.point, there, found.triangle };
  }
  return result;
}
}

std::vector<SharpLine> sharpLines(const TriangleSet& surface, double angle, double straight)
{
  const double cosine = cosineOf(angle);
  const double least =
    straight < 180 ? cosineOf(straight) : -2; // no cosine of rounded normals is less
  return Follower(surface, sharpEdges(surface, cosine, least), cosine).lines();
}

std::vector<WedgeEdge> wedgeEdges(
  const TriangleSet& surface, const std::vector<SharpLine>& lines, double spacing)
{
  std::vector<WedgeEdge> result;
  for (const SharpLine& line : lines)
  {
    std::vector<WedgeEdge> pieces;
    double length = 0;
    for (const SharpEdge& edge : line)
    {
      const Point& from = surface.points[edge.ends[0]];
      const Point whole = surface.points[edge.ends[1]] - from;
      const double wanted = std::ceil(2 * whole.norm() / spacing);
      const auto number = static_cast<int>(std::clamp(wanted, 1.0, 1e4));
      for (int i = 0; i < number; ++i)
      {
        pieces.push_back({ { from + i * whole / number, from + (i + 1) * whole / number },
          { surface.normals[edge.triangles[0]], surface.normals[edge.triangles[1]] } });
      }
      length += whole.norm();
    }
    if (length >= shortest * spacing)
    {
      result.insert(result.end(), pieces.begin(), pieces.end());
    }
  }
  return result;
}

std::vector<SurfacePoint> mirroredSamples(const TriangleSet& surface, const SurfaceTree& tree,
  const SpacingField& spacing, const std::vector<SharpLine>& lines)
{
  std::vector<std::array<SurfacePoint, 2>> pairs;
  std::vector<Point> places; // two for each pair
  std::vector<double> distances;
  for (const SharpLine& line : lines)
  {
    const std::vector<LinePlace> along = placesOn(line, surface, spacing);
    const int rows = rowsOf(line, surface);
    for (int row = 0; row < rows; ++row)
    {
      for (const LinePlace& place : along)
      {
        const double half = spacing.at(place.point) / 2;
        if (const auto pair = pairAt(place, surface, tree, (2 * row + 1) * half))
        {
          pairs.push_back(*pair);
          distances.push_back(half);
          places.push_back((*pair)[0].position);
          places.push_back((*pair)[1].position);
        }
      }
    }
  }
  // At a corner, two edges ask for the same sample of the face between them: it is taken once. A pair that is
  // near another one otherwise is left out.
  const Neighbors neighbors(places);
  std::vector<char> taken(places.size(), 0);
  std::vector<SurfacePoint> result;
  for (Index i = 0; i < count(pairs); ++i)
  {
    std::array<bool, 2> isThere{ false, false };
    bool isFree = true;
    for (int k = 0; k < 2; ++k)
    {
      constexpr double same = 0.2, near = 1.3; // of the distance from the edge; pairs are 2 apart
      for (const Index other : neighbors.within(2 * i + k, near * distances[i]))
      {
        const double apart = (places[other] - places[2 * i + k]).norm();
        isThere[k] = isThere[k] || (taken[other] && apart < same * distances[i]);
        isFree = isFree && (!taken[other] || apart < same * distances[i]);
      }
    }
    for (int k = 0; isFree && k < 2; ++k)
    {
      if (!isThere[k])
      {
        taken[2 * i + k] = 1;
        result.push_back(pairs[i][k]);
      }
    }
  }
  return result;
}
}
