// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/PolygonSoup.h"

#include "Base/DisjointSets.h"
#include "Base/NearDuplicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// For each point the first one at its place.
std::vector<Index> firstAtPlace(const std::vector<Point>& points)
{
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&points](Index i) {
    return std::make_tuple(points[i].x(), points[i].y(), points[i].z());
  };
  std::sort(order.begin(), order.end(),
    [&key](Index a, Index b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<Index> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool repeated = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = repeated ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// Makes those one, too, that are copies. @param first  see firstAtPlace()
/// @param copies  finds for each of some points the one that it is a copy of, or None
template <typename Copies>
void weld(const std::vector<Point>& points, const Copies& copies, std::vector<Index>& first)
{
  std::vector<Index> ids;
  std::vector<Point> places;
  for (Index i = 0; i < count(points); ++i)
  {
    if (first[i] == i)
    {
      ids.push_back(i);
      places.push_back(points[i]);
    }
  }
  const std::vector<Index> original = copies(places);
  for (Index i = 0; i < count(places); ++i)
  {
    first[ids[i]] = original[i] == None ? ids[i] : ids[original[i]];
  }
  for (Index& i : first)
  {
    i = first[i];
  }
}

/// Fills the points, each place once. @return  for each given point its place
std::vector<Index> distinctPlaces(const std::vector<Point>& points, Weld kind, PolygonSoup& soup)
{
  std::vector<Index> first = firstAtPlace(points);
  if (kind == Weld::Rounding)
  {
    const auto rounded = [](const std::vector<Point>& places) {
      return nearDuplicates(places, defaultTolerance(places, 0));
    };
    weld(points, rounded, first);
    weld(points, clusteredDuplicates, first);
  }
  std::vector<Index> place(points.size(), None);
  for (Index i = 0; i < count(points); ++i)
  {
    if (first[i] == i)
    {
      place[i] = count(soup.points);
      soup.points.push_back(points[i]);
    }
  }
  for (Index i = 0; i < count(points); ++i)
  {
    place[i] = place[first[i]];
  }
  return place;
}

/// The corners of a polygon without repeats of neighbours.
std::vector<Index> corners(const IndexLists::View& polygon, const std::vector<Index>& place)
{
  std::vector<Index> result;
  for (const Index p : polygon)
  {
    if (result.empty() || result.back() != place[p])
    {
      result.push_back(place[p]);
    }
  }
  while (result.size() > 1 && result.front() == result.back())
  {
    result.pop_back();
  }
  return result;
}

/// Triangles of a polygon, which need be neither flat nor convex.
std::vector<Triangle> triangulated(const std::vector<Index>& polygon, const PolygonSoup& soup)
{
  std::vector<Kernel::Point_3> line;
  line.reserve(polygon.size());
  for (const Index p : polygon)
  {
    const Point& point = soup.points[p];
    line.emplace_back(point.x(), point.y(), point.z());
  }
  std::vector<CGAL::Triple<int, int, int>> found;
  if (polygon.size() > 3)
  {
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(line, std::back_inserter(found));
  }
  std::vector<Triangle> result;
  result.reserve(polygon.size());
  for (const auto& t : found)
  {
    result.push_back({ polygon[t.first], polygon[t.second], polygon[t.third] });
  }
  for (std::size_t i = 2; found.empty() && i < polygon.size(); ++i)
  {
    result.push_back({ polygon[0], polygon[i - 1], polygon[i] });
  }
  return result;
}

/// Drops all but the first of triangles with the same corners.
void addDistinct(const std::vector<std::pair<Triangle, Index>>& triangles, PolygonSoup& soup)
{
  std::vector<std::pair<Triangle, Index>> sorted;
  for (Index i = 0; i < count(triangles); ++i)
  {
    Triangle t = triangles[i].first;
    std::sort(t.begin(), t.end());
    sorted.emplace_back(t, i);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> repeated(triangles.size(), 0);
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    repeated[sorted[i].second] = sorted[i].first == sorted[i - 1].first;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto& [t, polygon] = triangles[i];
    if (repeated[i] || t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      ++soup.droppedPolygons;
      continue;
    }
    soup.triangles.push_back(t);
    soup.polygons.push_back(polygon);
  }
}

/// The triangles at each edge: two ends and a triangle, sorted.
std::vector<std::array<Index, 3>> edgesOf(const std::vector<Triangle>& triangles)
{
  std::vector<std::array<Index, 3>> result;
  result.reserve(3 * triangles.size());
  for (Index i = 0; i < count(triangles); ++i)
  {
    const Triangle& t = triangles[i];
    for (int k = 0; k < 3; ++k)
    {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      result.push_back({ a, b, i });
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Calls with the first and behind the last of the entries of each edge.
template <typename Body>
void forEachEdge(const std::vector<std::array<Index, 3>>& edges, const Body& body)
{
  for (auto first = edges.begin(); first != edges.end();)
  {
    const auto last = std::find_if(first, edges.end(), [first](const std::array<Index, 3>& e) {
      return e[0] != (*first)[0] || e[1] != (*first)[1];
    });
    body(first, last);
    first = last;
  }
}
}

PolygonSoup polygonSoup(const std::vector<Point>& points, const IndexLists& polygons, Weld kind)
{
  PolygonSoup soup;
  const std::vector<Index> place = distinctPlaces(points, kind, soup);
  soup.mergedPoints = count(points) - count(soup.points);
  std::vector<std::pair<Triangle, Index>> triangles;
  for (Index i = 0; i < polygons.size(); ++i)
  {
    const std::vector<Index> polygon = corners(polygons[i], place);
    soup.droppedPolygons += polygon.size() < 3;
    if (polygon.size() >= 3)
    {
      for (const Triangle& t : triangulated(polygon, soup))
      {
        triangles.emplace_back(t, i);
      }
    }
  }
  addDistinct(triangles, soup);
  return soup;
}

void dropHangingPatches(PolygonSoup& soup)
{
  const auto edges = edgesOf(soup.triangles);
  DisjointSets patches(count(soup.triangles)); // joined where two triangles meet, and no others
  forEachEdge(edges, [&](auto first, auto last) {
    if (last - first == 2)
    {
      patches.unite((*first)[2], (*(first + 1))[2]);
    }
  });
  std::vector<char> isFree(soup.triangles.size(), 0); // the patch has a free border
  forEachEdge(edges, [&](auto first, auto last) {
    if (last - first == 1)
    {
      isFree[patches.find((*first)[2])] = 1;
    }
  });
  std::vector<char> isHeld(soup.triangles.size(), 0); // by edges of two others
  std::vector<char> stays(soup.triangles.size(), 0);  // something would be left open without it
  forEachEdge(edges, [&](auto first, auto last) {
    const auto hangs = [&](const auto& e) { return isFree[patches.find(e[2])]; };
    if (last - first > 2)
    {
      const bool oneHangs = last - first == 3 && std::count_if(first, last, hangs) == 1;
      std::vector<char>& mark = oneHangs ? isHeld : stays;
      std::for_each(first, last, [&](const auto& e) { mark[patches.find(e[2])] = 1; });
    }
  });
  Index kept = 0;
  for (Index i = 0; i < count(soup.triangles); ++i)
  {
    const Index patch = patches.find(i);
    if (!(isFree[patch] && isHeld[patch] && !stays[patch]))
    {
      soup.triangles[kept] = soup.triangles[i];
      soup.polygons[kept++] = soup.polygons[i];
    }
  }
  soup.droppedPolygons += count(soup.triangles) - kept;
  soup.triangles.resize(kept);
  soup.polygons.resize(kept);
}
}
