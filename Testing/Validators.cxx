// SPDX-License-Identifier: BSD-3-Clause
#include "Validators.h"

#include "Base/Lists.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <stdexcept>
#include <utility>

namespace validators
{
namespace
{
using Corners = std::vector<Index>;
using Columns = std::vector<Corners>;

/// All simplices of a complex by dimension, corners ascending, sorted, each once.
using Skeleton = std::array<Columns, 4>;

template <typename Simplices>
void append(Columns& to, const Simplices& simplices)
{
  for (const auto& simplex : simplices)
  {
    Corners corners(simplex.begin(), simplex.end());
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
    {
      throw std::invalid_argument("a simplex with a repeated corner");
    }
    to.push_back(std::move(corners));
  }
}

/// What is listed, without faces and with repetitions.
Skeleton listed(const Complex& complex)
{
  Skeleton result;
  for (const Index vertex : complex.vertices)
  {
    result[0].push_back({ vertex });
  }
  append(result[1], complex.edges);
  append(result[2], complex.triangles);
  append(result[3], complex.tetrahedra);
  return result;
}

void sortUnique(Columns& columns)
{
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
}

Corners without(const Corners& simplex, std::size_t corner)
{
  Corners face = simplex;
  face.erase(face.begin() + static_cast<std::ptrdiff_t>(corner));
  return face;
}

Skeleton closure(const Complex& complex)
{
  Skeleton result = listed(complex);
  for (std::size_t dimension = 3; dimension > 0; --dimension)
  {
    sortUnique(result[dimension]);
    for (const Corners& simplex : result[dimension])
    {
      for (std::size_t corner = 0; corner < simplex.size(); ++corner)
      {
        result[dimension - 1].push_back(without(simplex, corner));
      }
    }
  }
  sortUnique(result[0]);
  return result;
}

/// One column for each simplex: the numbers of its faces, ascending.
Columns boundaryMatrix(const Columns& simplices, const Columns& faces)
{
  Columns matrix;
  for (const Corners& simplex : simplices)
  {
    Corners column;
    for (std::size_t corner = 0; corner < simplex.size(); ++corner)
    {
      const auto found = std::lower_bound(faces.begin(), faces.end(), without(simplex, corner));
      column.push_back(static_cast<Index>(found - faces.begin()));
    }
    std::sort(column.begin(), column.end());
    matrix.push_back(std::move(column));
  }
  return matrix;
}

/// Rank over Z/2: columns are added until their last entries differ.
Index rank(Columns matrix, std::size_t rowCount)
{
  std::vector<Index> columnOfLast(rowCount, None);
  Index result = 0;
  Corners sum;
  for (std::size_t j = 0; j < matrix.size(); ++j)
  {
    Corners& column = matrix[j];
    while (!column.empty() && columnOfLast[column.back()] != None)
    {
      const Corners& other = matrix[columnOfLast[column.back()]];
      sum.clear();
      std::set_symmetric_difference(
        column.begin(), column.end(), other.begin(), other.end(), std::back_inserter(sum));
      column.swap(sum);
    }
    if (!column.empty())
    {
      columnOfLast[column.back()] = static_cast<Index>(j);
      ++result;
    }
  }
  return result;
}

Edge undirected(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

using EdgeUses = std::map<Edge, std::vector<Index>>;

EdgeUses trianglesOfEdges(const std::vector<Triangle>& triangles)
{
  EdgeUses uses;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      uses[undirected(triangles[t][i], triangles[t][(i + 1) % 3])].push_back(static_cast<Index>(t));
    }
  }
  return uses;
}

/// A corner of a face: the vertex there and the next and previous one round the face.
struct FaceCorner
{
  Index face, vertex, next, previous;
};

std::vector<FaceCorner> faceCorners(const IndexLists& faces)
{
  std::vector<FaceCorner> result;
  for (Index f = 0; f < faces.size(); ++f)
  {
    const auto face = faces[f];
    for (Index i = 0; i < face.size(); ++i)
    {
      const Index next = face[(i + 1) % face.size()];
      const Index previous = face[(i + face.size() - 1) % face.size()];
      result.push_back({ f, face[i], next, previous });
    }
  }
  return result;
}

class Groups
{
public:
  explicit Groups(std::size_t count)
    : parent(count)
  {
    std::iota(this->parent.begin(), this->parent.end(), 0);
  }
  Index find(Index i)
  {
    while (this->parent[i] != i)
    {
      i = this->parent[i] = this->parent[this->parent[i]];
    }
    return i;
  }
  void join(Index a, Index b) { this->parent[this->find(a)] = this->find(b); }

private:
  std::vector<Index> parent;
};

/// For each face the number of its piece of the surface, a face of that piece.
std::vector<Index> piecesOfSurface(const IndexLists& faces)
{
  Groups groups(static_cast<std::size_t>(faces.size()));
  std::map<Edge, Index> faceOfEdge;
  for (const FaceCorner& corner : faceCorners(faces))
  {
    const auto [found, added] =
      faceOfEdge.emplace(undirected(corner.vertex, corner.next), corner.face);
    if (!added)
    {
      groups.join(found->second, corner.face);
    }
  }
  std::vector<Index> result;
  for (Index f = 0; f < faces.size(); ++f)
  {
    result.push_back(groups.find(f));
  }
  return result;
}
}

Betti bettiNumbers(const Complex& complex)
{
  const Skeleton skeleton = closure(complex);
  std::array<Index, 5> ranks{ 0, 0, 0, 0, 0 }; // of the boundary of simplices by dimension
  for (std::size_t d = 1; d < 4; ++d)
  {
    ranks[d] = rank(boundaryMatrix(skeleton[d], skeleton[d - 1]), skeleton[d - 1].size());
  }
  Betti betti;
  for (std::size_t d = 0; d < 3; ++d)
  {
    betti[d] = medial::count(skeleton[d]) - ranks[d] - ranks[d + 1];
  }
  return betti;
}

Index eulerCharacteristic(const Complex& complex)
{
  const Skeleton skeleton = closure(complex);
  return medial::count(skeleton[0]) - medial::count(skeleton[1]) + medial::count(skeleton[2]) -
    medial::count(skeleton[3]);
}

Index repeatedSimplices(const Complex& complex)
{
  Index repeated = 0;
  for (Columns& simplices : listed(complex))
  {
    const std::size_t before = simplices.size();
    sortUnique(simplices);
    repeated += static_cast<Index>(before - simplices.size());
  }
  return repeated;
}

Index unusedPoints(Index pointCount, const Complex& complex)
{
  std::vector<char> used(static_cast<std::size_t>(pointCount), 0);
  for (const Columns& simplices : listed(complex))
  {
    for (const Corners& simplex : simplices)
    {
      for (const Index corner : simplex)
      {
        used.at(static_cast<std::size_t>(corner)) = 1;
      }
    }
  }
  return static_cast<Index>(std::count(used.begin(), used.end(), 0));
}

std::vector<Index> floodFill(const std::vector<Triangle>& triangles)
{
  const EdgeUses uses = trianglesOfEdges(triangles);
  std::vector<Index> labels(triangles.size(), None);
  Index label = 0;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed)
  {
    if (labels[seed] != None)
    {
      continue;
    }
    std::vector<Index> open{ static_cast<Index>(seed) };
    labels[seed] = label;
    while (!open.empty())
    {
      const Triangle triangle = triangles[open.back()];
      open.pop_back();
      for (int i = 0; i < 3; ++i)
      {
        const auto& both = uses.at(undirected(triangle[i], triangle[(i + 1) % 3]));
        for (const Index next : both)
        {
          if (both.size() == 2 && labels[next] == None)
          {
            labels[next] = label;
            open.push_back(next);
          }
        }
      }
    }
    ++label;
  }
  return labels;
}

std::vector<int> levels(const std::vector<Triangle>& triangles, const std::vector<Index>& labels)
{
  const Index labelCount = labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
  std::vector<int> result(static_cast<std::size_t>(labelCount), 0);
  std::set<Edge> neighbours;
  for (const auto& [edge, around] : trianglesOfEdges(triangles))
  {
    if (around.size() == 1)
    {
      result[labels[around[0]]] = 1;
    }
    for (const Index a : around)
    {
      for (const Index b : around)
      {
        neighbours.insert({ labels[a], labels[b] });
      }
    }
  }
  bool changed = true;
  for (int level = 1; changed; ++level)
  {
    changed = false;
    for (const Edge& pair : neighbours)
    {
      if (result[pair[0]] == level && result[pair[1]] == 0)
      {
        result[pair[1]] = level + 1;
        changed = true;
      }
    }
  }
  return result;
}

bool sameGroups(const std::vector<Index>& a, const std::vector<Index>& b)
{
  if (a.size() != b.size())
  {
    return false;
  }
  std::map<Index, Index> there, back;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    if (there.emplace(a[i], b[i]).first->second != b[i] ||
      back.emplace(b[i], a[i]).first->second != a[i])
    {
      return false;
    }
  }
  return true;
}

bool isClosed(const IndexLists& faces)
{
  std::map<Edge, int> uses;
  for (const FaceCorner& corner : faceCorners(faces))
  {
    ++uses[undirected(corner.vertex, corner.next)];
  }
  return !uses.empty() &&
    std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 2; });
}

bool isOriented(const IndexLists& faces)
{
  std::set<Edge> directed;
  for (const FaceCorner& corner : faceCorners(faces))
  {
    if (corner.vertex == corner.next || !directed.insert({ corner.vertex, corner.next }).second)
    {
      return false;
    }
  }
  return true;
}

bool isTwoManifold(const IndexLists& faces)
{
  if (!isClosed(faces))
  {
    return false;
  }
  const std::vector<FaceCorner> corners = faceCorners(faces);
  Groups fans(corners.size());
  std::map<std::pair<Index, Edge>, Index> cornerAt; // by vertex and edge at it
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    for (const Index other : { corners[c].next, corners[c].previous })
    {
      const Index vertex = corners[c].vertex;
      const auto [found, added] =
        cornerAt.emplace(std::pair(vertex, undirected(vertex, other)), static_cast<Index>(c));
      if (!added)
      {
        fans.join(found->second, static_cast<Index>(c));
      }
    }
  }
  std::map<Index, Index> fanOfVertex;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const Index fan = fans.find(static_cast<Index>(c));
    if (fanOfVertex.emplace(corners[c].vertex, fan).first->second != fan)
    {
      return false;
    }
  }
  return true;
}

Index eulerCharacteristic(const IndexLists& faces)
{
  std::set<Index> vertices;
  std::set<Edge> edges;
  for (const FaceCorner& corner : faceCorners(faces))
  {
    vertices.insert(corner.vertex);
    edges.insert(undirected(corner.vertex, corner.next));
  }
  return medial::count(vertices) - medial::count(edges) + faces.size();
}

double enclosedVolume(const std::vector<Point>& points, const IndexLists& faces)
{
  double sum = 0;
  const IndexLists triangles = triangulated(faces);
  for (Index t = 0; t < triangles.size(); ++t)
  {
    const auto triangle = triangles[t];
    const Point& a = points[triangle[0]];
    sum += orientation(points[0], a, points[triangle[1]], points[triangle[2]]);
  }
  return sum / 6;
}

Betti bettiOfSolid(const std::vector<Point>& points, const IndexLists& faces)
{
  if (!isTwoManifold(faces) || !isOriented(faces))
  {
    throw std::invalid_argument("not a closed, oriented 2-manifold");
  }
  std::map<Index, IndexLists> pieces;
  const std::vector<Index> pieceOfFace = piecesOfSurface(faces);
  for (Index f = 0; f < faces.size(); ++f)
  {
    IndexLists& piece = pieces[pieceOfFace[f]];
    piece.items.insert(piece.items.end(), faces[f].begin(), faces[f].end());
    piece.close();
  }
  Betti betti{ 0, 0, 0 };
  for (const auto& [number, piece] : pieces)
  {
    betti[enclosedVolume(points, piece) > 0 ? 0 : 2] += 1;
    betti[1] += (2 - eulerCharacteristic(piece)) / 2;
  }
  return betti;
}

IndexLists triangulated(const IndexLists& faces)
{
  IndexLists result;
  for (Index f = 0; f < faces.size(); ++f)
  {
    const auto face = faces[f];
    for (Index i = 2; i < face.size(); ++i)
    {
      result.items.insert(result.items.end(), { face[0], face[i - 1], face[i] });
      result.close();
    }
  }
  return result;
}

NearestPoint::NearestPoint(std::vector<Point> thePoints)
  : points(std::move(thePoints))
  , order(this->points.size())
{
  std::iota(this->order.begin(), this->order.end(), 0);
  std::sort(this->order.begin(), this->order.end(),
    [this](Index a, Index b) { return this->points[a].x() < this->points[b].x(); });
  for (const Index i : this->order)
  {
    this->x.push_back(this->points[i].x());
  }
}

Index NearestPoint::operator()(const Point& place, Index except) const
{
  Index nearest = None;
  double best = std::numeric_limits<double>::infinity();
  const auto look = [&](std::size_t k) {
    const Index i = this->order[k];
    const double distance = (this->points[i] - place).norm();
    if (i != except && distance < best)
    {
      best = distance;
      nearest = i;
    }
  };
  const std::size_t start = static_cast<std::size_t>(
    std::lower_bound(this->x.begin(), this->x.end(), place.x()) - this->x.begin());
  std::size_t up = start, down = start;
  bool goUp = true, goDown = true;
  while (goUp || goDown)
  {
    goUp = up < this->x.size() && this->x[up] - place.x() < best;
    if (goUp)
    {
      look(up++);
    }
    goDown = down > 0 && place.x() - this->x[down - 1] < best;
    if (goDown)
    {
      look(--down);
    }
  }
  return nearest;
}

double NearestPoint::distance(const Point& place, Index except) const
{
  const Index nearest = (*this)(place, except);
  return nearest == None ? std::numeric_limits<double>::infinity()
                         : (this->points[nearest] - place).norm();
}

Index nearDuplicates(const std::vector<Point>& points, double tolerance)
{
  const NearestPoint nearest(points);
  Index result = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result += nearest.distance(points[i], static_cast<Index>(i)) <= tolerance ? 1 : 0;
  }
  return result;
}

double meanSpacing(const std::vector<Point>& points)
{
  const NearestPoint nearest(points);
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    sum += nearest.distance(points[i], static_cast<Index>(i));
  }
  return sum / static_cast<double>(points.size());
}

double hausdorffDistance(const std::vector<Point>& from, const std::vector<Point>& to)
{
  const NearestPoint nearest(to);
  double largest = 0;
  for (const Point& point : from)
  {
    largest = std::max(largest, nearest.distance(point));
  }
  return largest;
}

double diagonal(const std::vector<Point>& points)
{
  Point lower = points.at(0), upper = points.at(0);
  for (const Point& point : points)
  {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  return (upper - lower).norm();
}

Point nearestOnTriangle(const Point& p, const Point& a, const Point& b, const Point& c)
{
  const Point u = b - a, v = c - a;
  const Point normal = u.cross(v);
  const double area = normal.squaredNorm();
  if (area > 0)
  {
    const double s = (p - a).cross(v).dot(normal) / area;
    const double t = u.cross(p - a).dot(normal) / area;
    if (s >= 0 && t >= 0 && s + t <= 1)
    {
      return a + s * u + t * v;
    }
  }
  Point best = a;
  const std::array<std::array<const Point*, 2>, 3> sides{ { { &a, &b }, { &b, &c }, { &c, &a } } };
  for (const auto& side : sides)
  {
    const Point along = *side[1] - *side[0];
    const double length = along.squaredNorm();
    const double t = length > 0 ? (p - *side[0]).dot(along) / length : 0;
    const Point candidate = *side[0] + std::clamp(t, 0.0, 1.0) * along;
    if ((candidate - p).norm() < (best - p).norm())
    {
      best = candidate;
    }
  }
  return best;
}

Index pointsInside(const Ball& ball, const std::vector<Point>& points, double tolerance)
{
  return static_cast<Index>(std::count_if(points.begin(), points.end(),
    [&](const Point& point) { return (point - ball.center).norm() < ball.radius - tolerance; }));
}

double clearance(const Point& point, const std::vector<Ball>& balls)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls)
  {
    least = std::min(least, (point - ball.center).norm() - ball.radius);
  }
  return least;
}

double orientation(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

bool samePolygons(const Polygons& a, const Polygons& b, double tolerance)
{
  if (a.points.size() != b.points.size() || a.polygons.size() != b.polygons.size())
  {
    return false;
  }
  const NearestPoint nearest(b.points);
  std::vector<Index> image;
  for (const Point& point : a.points)
  {
    image.push_back(nearest(point));
    if (image.back() == None || (b.points[image.back()] - point).norm() > tolerance)
    {
      return false;
    }
  }
  if (std::set<Index>(image.begin(), image.end()).size() != image.size())
  {
    return false;
  }
  std::multiset<std::set<Index>> carried, there;
  for (const std::vector<Index>& polygon : a.polygons)
  {
    std::set<Index> corners;
    for (const Index corner : polygon)
    {
      corners.insert(image[corner]);
    }
    carried.insert(corners);
  }
  for (const std::vector<Index>& polygon : b.polygons)
  {
    there.insert(std::set<Index>(polygon.begin(), polygon.end()));
  }
  return carried == there;
}
}
