// SPDX-License-Identifier: BSD-3-Clause
#include "Validators.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

namespace validators
{
namespace
{
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
}
