// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/FaceTriangulation.h"

#include "Axis/FreePlaces.h"
#include "Base/EdgeTable.h"
#include "Base/Polygons.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

namespace medial
{
namespace
{
/// Where the sites are that a polygon is equally far from; none for one that was filled in.
std::vector<Point> sitesOf(
  const FacePolygon& polygon, const SiteTriangulation& sites, const std::vector<Point>& positions)
{
  std::vector<Point> result;
  const auto add = [&](const auto& some) {
    for (const Index site : some)
    {
      result.push_back(positions[site]);
    }
  };
  if (polygon.siteEdge != None)
  {
    add(sites.edges.edges[polygon.siteEdge]);
  }
  else if (polygon.siteFacet[0] != None)
  {
    add(polygon.siteFacet);
  }
  return result;
}

SiteView viewOf(const std::vector<Ball>& corners, const std::vector<Point>& sites)
{
  Point centroid = Point::Zero();
  for (const Ball& corner : corners)
  {
    centroid += corner.center / static_cast<double>(corners.size());
  }
  return sites.empty() ? siteView(corners) : siteView(centroid, sites);
}

/// Of a triangle of an axis that has no other cells yet.
SiteView viewOfTriangle(const AxisComplex& axis, Index triangle, const std::vector<Point>& sites)
{
  if (sites.empty())
  {
    return siteView(cornerBalls(axis, triangle));
  }
  Point centroid = Point::Zero();
  for (const Index p : axis.cells.triangles[triangle])
  {
    centroid += axis.points[p] / 3.0;
  }
  return siteView(centroid, sites);
}

/// Sees to it that a centroid that was added to the points is at no other point's place.
class AddedCentroids
{
public:
  explicit AddedCentroids(const Frame& theFrame)
    : frame(theFrame)
  {
  }

  /// @param points  of the axis; the last one is the centroid
  void place(std::vector<Point>& points)
  {
    if (!this->places) // most axes have no centroid
    {
      std::vector<Point> taken;
      std::transform(points.begin(), points.end() - 1, std::back_inserter(taken),
        [this](const Point& point) -> Point { return this->frame.toLocal(point); });
      this->places.emplace(taken);
    }
    const Point middle = this->frame.toLocal(points.back());
    const Point place = this->places->takeNear(middle);
    if (place != middle)
    {
      points.back() = this->frame.toWorld(place);
    }
  }

private:
  const Frame& frame;
  std::optional<FreePlaces> places;
};

/// Triangulates polygons into cells of the axis.
void addTriangles(const std::vector<FacePolygon>& polygons, const SiteTriangulation& sites,
  const SingularPoints& singularPoints, const Frame& frame, EdgeSet& edges, AxisComplex& axis)
{
  // Two polygons of three corners may be the same triangle, which counts for the first of them. All others have a
  // diagonal of their own.
  const auto isTriangle = [](const FacePolygon& polygon) { return polygon.corners.size() == 3; };
  TriangleTable known(std::count_if(polygons.begin(), polygons.end(), isTriangle));
  AddedCentroids centroids(frame);
  Index number = 0;
  for (const FacePolygon& polygon : polygons)
  {
    if (polygon.corners.size() < 3)
    {
      continue;
    }
    const Edge ends =
      polygon.siteEdge == None ? Edge{ None, None } : sites.edges.edges[polygon.siteEdge];
    const auto sampleOf = [&](int k) {
      return ends[k] == None ? None : singularPoints.samples[ends[k]];
    };
    const std::vector<Point> positions = sitesOf(polygon, sites, singularPoints.positions);
    const Index firstOfPolygon = count(axis.cells.triangles);
    double radius = 0;
    for (const Index p : polygon.corners)
    {
      radius += axis.radii[p] / static_cast<double>(polygon.corners.size());
    }
    for (const Triangle& triangle : triangulate(polygon.corners, axis.points, edges))
    {
      if (!isTriangle(polygon) || known.insert(triangle, number))
      {
        axis.cells.triangles.push_back(triangle);
        axis.polygonOfCell.push_back(number);
        axis.samplesOfCell.push_back({ sampleOf(0), sampleOf(1) });
      }
    }
    if (axis.points.size() > axis.radii.size())
    {
      centroids.place(axis.points);
      axis.radii.push_back(radius);
      axis.ballOfPoint.push_back(None);
    }
    for (Index t = firstOfPolygon; t < count(axis.cells.triangles); ++t)
    {
      axis.siteViews.push_back(viewOfTriangle(axis, t, positions));
    }
    ++number;
  }
}

/// Adds the edges that are sides of no triangle and the points that are in no cell.
/// @param dangling  edges, ascending, with their sites
void addLowerCells(const std::map<Edge, std::vector<Point>>& dangling, const EdgeSet& sidesOfFaces,
  AxisComplex& axis)
{
  std::vector<SiteView> views;
  const auto ballAt = [&axis](Index p) { return Ball{ axis.points[p], axis.radii[p] }; };
  for (const auto& [edge, sites] : dangling)
  {
    if (!sidesOfFaces.contains(edge[0], edge[1]))
    {
      axis.cells.edges.push_back(edge);
      views.push_back(viewOf({ ballAt(edge[0]), ballAt(edge[1]) }, sites));
    }
  }
  std::vector<char> used(axis.points.size(), 0);
  const auto use = [&used](const auto& cells) {
    for (const auto& cell : cells)
    {
      for (const Index p : cell)
      {
        used[p] = 1;
      }
    }
  };
  use(axis.cells.edges);
  use(axis.cells.triangles);
  for (Index p = 0; p < count(axis.points); ++p)
  {
    if (!used[p])
    {
      views.insert(views.begin() + count(axis.cells.vertices), siteView({ ballAt(p) }));
      axis.cells.vertices.push_back(p);
    }
  }
  axis.siteViews.insert(axis.siteViews.begin(), views.begin(), views.end());
  const std::size_t lower = axis.cells.firstTriangle();
  axis.polygonOfCell.insert(axis.polygonOfCell.begin(), lower, None);
  axis.samplesOfCell.insert(axis.samplesOfCell.begin(), lower, Edge{ None, None });
}
}

void addCells(const std::vector<FacePolygon>& polygons, const SiteTriangulation& sites,
  const SingularPoints& singularPoints, const Frame& frame, AxisComplex& axis,
  const Execution& execution)
{
  std::map<Edge, std::vector<Point>> dangling;
  std::vector<char> hasDangling(axis.points.size(), 0);
  for (const FacePolygon& polygon : polygons)
  {
    const std::vector<Index>& corners = polygon.corners;
    if (corners.size() == 2)
    {
      dangling.emplace(Edge{ std::min(corners[0], corners[1]), std::max(corners[0], corners[1]) },
        sitesOf(polygon, sites, singularPoints.positions));
      hasDangling[corners[0]] = hasDangling[corners[1]] = 1;
    }
  }
  EdgeSet sidesOfFaces;               // that may be dangling edges, too
  EdgeSet edges(5 * polygons.size()); // of polygons of six corners
  for (const FacePolygon& polygon : polygons)
  {
    const std::vector<Index>& corners = polygon.corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      const Index a = corners[k], b = corners[(k + 1) % corners.size()];
      edges.insert(a, b);
      if (corners.size() > 2 && hasDangling[a] && hasDangling[b])
      {
        sidesOfFaces.insert(a, b);
      }
    }
  }
  execution.poll();
  addTriangles(polygons, sites, singularPoints, frame, edges, axis);
  execution.poll();
  addLowerCells(dangling, sidesOfFaces, axis);
}
}
