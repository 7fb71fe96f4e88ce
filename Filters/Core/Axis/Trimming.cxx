// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Trimming.h"

#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{
/// For each of `size` values the numbers of the lists that hold it.
IndexLists listsWith(const IndexLists& lists, Index size)
{
  return listsByKey(size, [&lists](const auto& body) {
    for (Index i = 0; i < lists.size(); ++i)
    {
      std::for_each(lists[i].begin(), lists[i].end(), [&](Index value) { body(value, i); });
    }
  });
}

/// Faces that go on into one another are a piece; pieces with a face off their border are sheets, the
/// others slivers.
class Trimmer
{
public:
  Trimmer(const SheetComplex& given, const std::vector<Polygon>& all)
    : complex(given)
    , polygons(all)
    , isFace(all.size())
    , goneVertex(given.points.size(), 0)
    , pieces(0)
  {
    this->numberSides();
  }

  /// Collapses the pieces all of whose poles are elsewhere, too.
  void removePieces()
  {
    this->findPieces();
    std::vector<std::vector<Index>> faces(this->polygons.size()), vertices(faces.size());
    for (Index p = 0; p < count(faces); ++p)
    {
      if (this->isFace[p])
      {
        const std::vector<Index>& corners = this->polygons[p].corners;
        const Index piece = this->pieces.find(p);
        faces[piece].push_back(p);
        vertices[piece].insert(vertices[piece].end(), corners.begin(), corners.end());
      }
    }
    std::vector<Index> uses = this->danglingSides(); // and pieces, at each vertex
    for (std::vector<Index>& own : vertices)
    {
      sortUnique(own);
      std::for_each(own.begin(), own.end(), [&uses](Index v) { ++uses[v]; });
    }
    for (std::size_t piece = 0; piece < faces.size(); ++piece)
    {
      const std::vector<Index>& own = vertices[piece];
      const bool isNeeded = std::any_of(own.begin(), own.end(),
        [&](Index v) { return this->complex.ball[v] != None && uses[v] == 1; });
      if (!isNeeded && this->collapseAll(faces[piece]))
      {
        std::for_each(own.begin(), own.end(), [&uses](Index v) { --uses[v]; });
      }
    }
  }

  /// Cuts sheets apart that are one around the end of a third.
  void separateSheets()
  {
    std::vector<Index> seams;
    for (Index s = 0; s < count(this->sides); ++s)
    {
      if (this->faceCount[s] > 2 && this->isTripod(s, this->facesAt(s)))
      {
        seams.push_back(s);
      }
    }
    for (bool changed = true; changed;)
    {
      changed = false;
      this->findPieces();
      for (const Index s : seams)
      {
        for (const Index v : this->sides[s])
        {
          while (this->isSeam(s) && this->separate(s, v))
          {
            changed = true;
          }
        }
      }
    }
  }

  /// The faces that are left, and the sides that are left in none.
  std::vector<Polygon> result() const
  {
    std::vector<Polygon> kept;
    for (Index p = 0; p < count(this->polygons); ++p)
    {
      if (this->isFace[p])
      {
        kept.push_back(this->polygons[p]);
      }
    }
    for (Index s = 0; s < count(this->sides); ++s)
    {
      if (this->faceCount[s] == 0)
      {
        const Polygon& former = this->polygons[this->users[s][0]];
        kept.push_back(
          { { this->sides[s][0], this->sides[s][1] }, former.siteEdge, former.siteFacet });
      }
    }
    return kept;
  }

  const std::vector<char>& gone() const { return this->goneVertex; }

private:
  void numberSides()
  {
    std::vector<std::vector<std::pair<Index, Index>>> uses(this->complex.points.size());
    for (Index p = 0; p < count(this->polygons); ++p)
    {
      const std::vector<Index>& corners = this->polygons[p].corners;
      this->isFace[p] = corners.size() > 2;
      for (std::size_t i = 0; i < (this->isFace[p] ? corners.size() : 1); ++i)
      {
        const Index a = corners[i], b = corners[(i + 1) % corners.size()];
        uses[std::min(a, b)].push_back({ std::max(a, b), p });
      }
    }
    IndexLists ends;
    for (Index v = 0; v < count(uses); ++v)
    {
      std::sort(uses[v].begin(), uses[v].end());
      for (auto use = uses[v].begin(); use != uses[v].end();)
      {
        const Index other = use->first;
        this->sides.push_back({ v, other });
        this->faceCount.push_back(0);
        ends.items.insert(ends.items.end(), { v, other });
        ends.close();
        for (; use != uses[v].end() && use->first == other; ++use)
        {
          this->users.items.push_back(use->second);
          this->faceCount.back() += this->isFace[use->second];
        }
        this->users.close();
      }
    }
    this->sidesOfPolygon = listsWith(this->users, count(this->polygons));
    this->sidesOfVertex = listsWith(ends, count(this->complex.points));
  }

  /// For each vertex: how many of its sides are in no face?
  std::vector<Index> danglingSides() const
  {
    std::vector<Index> result(this->complex.points.size(), 0);
    for (Index s = 0; s < count(this->sides); ++s)
    {
      if (this->faceCount[s] == 0)
      {
        ++result[this->sides[s][0]], ++result[this->sides[s][1]];
      }
    }
    return result;
  }

  std::vector<Index> facesAt(Index side) const
  {
    std::vector<Index> faces;
    for (const Index p : this->users[side])
    {
      if (this->isFace[p])
      {
        faces.push_back(p);
      }
    }
    return faces;
  }

  /// Cosine of the angle at which the site that moves farther is seen to move from one face to another.
  double cosine(Index vertex, const Edge& p, const Edge& q) const
  {
    const auto between = [&](Index a, Index b) {
      const Point& from = this->complex.points[vertex];
      const Point u = this->complex.sites[a] - from, v = this->complex.sites[b] - from;
      return a == b ? 1 : u.dot(v) / std::sqrt(u.squaredNorm() * v.squaredNorm());
    };
    return std::max(std::min(between(p[0], q[0]), between(p[1], q[1])),
      std::min(between(p[0], q[1]), between(p[1], q[0])));
  }

  /// Does a site jump, between two faces at a side, farther than its distance from one of the ends?
  bool turns(Index side, Index p, Index q) const
  {
    const Index a = this->polygons[p].siteEdge, b = this->polygons[q].siteEdge;
    if (a == None || b == None)
    {
      return false;
    }
    const Edge &ofP = this->complex.siteEdges[a], &ofQ = this->complex.siteEdges[b];
    const Edge& ends = this->sides[side];
    return std::min(this->cosine(ends[0], ofP, ofQ), this->cosine(ends[1], ofP, ofQ)) < 0.5;
  }

  /// Are there three faces that turn pairwise?
  bool isTripod(Index side, const std::vector<Index>& faces) const
  {
    std::vector<Index> turning;
    for (const Index p : faces)
    {
      if (std::all_of(
            turning.begin(), turning.end(), [&](Index q) { return this->turns(side, p, q); }))
      {
        turning.push_back(p);
      }
    }
    return turning.size() > 2;
  }

  /// Faces go on into one another where they are the only two, or don't turn.
  void findPieces()
  {
    this->pieces = DisjointSets(count(this->polygons));
    std::vector<char> atBorder(this->complex.points.size(), 0);
    for (Index s = 0; s < count(this->sides); ++s)
    {
      const std::vector<Index> faces = this->facesAt(s);
      for (std::size_t i = 0; i < faces.size(); ++i)
      {
        for (std::size_t j = 0; j < i; ++j)
        {
          if (faces.size() == 2 || !this->turns(s, faces[j], faces[i]))
          {
            this->pieces.unite(faces[j], faces[i]);
          }
        }
      }
      if (faces.size() == 1)
      {
        atBorder[this->sides[s][0]] = atBorder[this->sides[s][1]] = 1;
      }
    }
    this->isSheet.assign(this->polygons.size(), 0);
    for (Index p = 0; p < count(this->polygons); ++p)
    {
      const std::vector<Index>& corners = this->polygons[p].corners;
      if (this->isFace[p] &&
        std::none_of(corners.begin(), corners.end(), [&](Index v) { return atBorder[v]; }))
      {
        this->isSheet[this->pieces.find(p)] = 1;
      }
    }
  }

  /// The faces at a side that are no slivers.
  std::vector<Index> sheetsAt(Index side)
  {
    std::vector<Index> sheets = this->facesAt(side);
    sheets.erase(std::remove_if(sheets.begin(), sheets.end(),
                   [this](Index p) { return !this->isSheet[this->pieces.find(p)]; }),
      sheets.end());
    return sheets;
  }

  bool isSeam(Index side)
  {
    return this->faceCount[side] > 2 && this->isTripod(side, this->sheetsAt(side));
  }

  /// Takes a face away from between two sheets of a seam that are one around its end.
  bool separate(Index seam, Index vertex)
  {
    const std::vector<Index> sheets = this->sheetsAt(seam);
    for (std::size_t i = 0; i < sheets.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (this->turns(seam, sheets[i], sheets[j]))
        {
          const std::vector<Index> path = this->around(seam, vertex, sheets[i], sheets[j]);
          if (!path.empty())
          {
            return this->open(path, vertex);
          }
        }
      }
    }
    return false;
  }

  /// The faces that lead around a vertex, over sides without a third sheet, from one face at a seam to
  /// another, both included; none where there is no way.
  std::vector<Index> around(Index seam, Index vertex, Index from, Index to)
  {
    std::vector<std::pair<Index, Index>> reached{ { from,
      None } }; // and the place of the one before
    for (Index i = 0; i < count(reached); ++i)
    {
      if (reached[i].first == to)
      {
        std::vector<Index> path;
        for (Index k = i; k != None; k = reached[k].second)
        {
          path.push_back(reached[k].first);
        }
        return path;
      }
      for (const Index s : this->sidesOfPolygon[reached[i].first])
      {
        const Edge& ends = this->sides[s];
        const bool isHere = s != seam && (ends[0] == vertex || ends[1] == vertex);
        const std::vector<Index> sheets = isHere ? this->sheetsAt(s) : std::vector<Index>{};
        for (const Index q : sheets)
        {
          const auto isQ = [q](const std::pair<Index, Index>& r) { return r.first == q; };
          if (sheets.size() == 2 && std::none_of(reached.begin(), reached.end(), isQ))
          {
            reached.push_back({ q, i });
          }
        }
      }
    }
    return {};
  }

  double radius(Index polygon, Index vertex) const
  {
    const Index edge = this->polygons[polygon].siteEdge;
    return edge == None
      ? 0
      : (this->complex.points[vertex] - this->complex.sites[this->complex.siteEdges[edge][0]])
          .norm();
  }

  /// Mean radius at the corners.
  double depth(Index polygon) const
  {
    const std::vector<Index>& corners = this->polygons[polygon].corners;
    const double sum = std::accumulate(corners.begin(), corners.end(), 0.0,
      [&](double part, Index v) { return part + this->radius(polygon, v); });
    return sum / count(corners);
  }

  /// Collapses the nearest face with a free side to a path around a vertex, in its ball; of several the
  /// shallowest. The ends of the path are at the seam: they count only if there are no others.
  bool open(const std::vector<Index>& path, Index vertex)
  {
    const double reach =
      std::max(this->radius(path.front(), vertex), this->radius(path.back(), vertex));
    std::vector<Index> reached = path;
    if (path.size() > 2)
    {
      reached.assign(path.begin() + 1, path.end() - 1);
    }
    for (std::size_t begin = 0; begin < reached.size();)
    {
      const std::size_t end = reached.size();
      Index best = None;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index p = reached[i];
        if (this->freeSide(p) != None && (best == None || this->depth(p) < this->depth(best)))
        {
          best = p;
        }
      }
      if (best != None)
      {
        return this->collapse(best);
      }
      for (; begin < end; ++begin)
      {
        this->reachNext(reached[begin], vertex, reach, reached);
      }
    }
    return false;
  }

  /// Appends the faces next to one that have a corner near a vertex.
  void reachNext(Index face, Index vertex, double reach, std::vector<Index>& reached) const
  {
    const auto isNear = [&](Index v) {
      return (this->complex.points[v] - this->complex.points[vertex]).norm() < reach;
    };
    for (const Index s : this->sidesOfPolygon[face])
    {
      for (const Index q : this->faceCount[s] == 2 ? this->facesAt(s) : std::vector<Index>{})
      {
        const std::vector<Index>& corners = this->polygons[q].corners;
        if (std::find(reached.begin(), reached.end(), q) == reached.end() &&
          std::any_of(corners.begin(), corners.end(), isNear))
        {
          reached.push_back(q);
        }
      }
    }
  }

  Index freeSide(Index polygon) const
  {
    for (const Index s : this->sidesOfPolygon[polygon])
    {
      if (this->faceCount[s] == 1)
      {
        return s;
      }
    }
    return None;
  }

  /// Removes a face with a free side, and the hair that this leaves.
  bool collapse(Index polygon)
  {
    const Index side = this->isFace[polygon] ? this->freeSide(polygon) : None;
    if (side == None)
    {
      return false;
    }
    for (const Index s : this->sidesOfPolygon[polygon])
    {
      --this->faceCount[s];
    }
    this->isFace[polygon] = 0;
    this->faceCount[side] = None;
    for (const Index v : this->polygons[polygon].corners)
    {
      this->removeHair(v);
    }
    return true;
  }

  /// @return  are all of the faces gone?
  bool collapseAll(const std::vector<Index>& faces)
  {
    for (bool changed = true; changed;)
    {
      changed = false;
      for (const Index p : faces)
      {
        changed = this->collapse(p) || changed;
      }
    }
    return std::none_of(faces.begin(), faces.end(), [this](Index p) { return this->isFace[p]; });
  }

  void removeHair(Index vertex)
  {
    while (!this->goneVertex[vertex])
    {
      Index only = None, alive = 0;
      for (const Index s : this->sidesOfVertex[vertex])
      {
        if (this->faceCount[s] != None)
        {
          ++alive;
          only = s;
        }
      }
      if (alive != 1 || this->faceCount[only] != 0)
      {
        return;
      }
      this->faceCount[only] = None;
      this->goneVertex[vertex] = 1;
      vertex = this->sides[only][0] == vertex ? this->sides[only][1] : this->sides[only][0];
    }
  }

  const SheetComplex& complex;
  const std::vector<Polygon>& polygons;
  std::vector<char> isFace; ///< of the polygons: more than two corners, and not collapsed
  std::vector<Edge> sides;
  std::vector<Index> faceCount; ///< the faces at each side, or None if it is gone
  IndexLists users;             ///< the polygons that each side had at first
  IndexLists sidesOfPolygon, sidesOfVertex;
  std::vector<char> goneVertex;
  DisjointSets pieces;       ///< of faces, when they were last found
  std::vector<char> isSheet; ///< of the pieces by their first faces
};
}

std::vector<char> trimSheets(const SheetComplex& complex, std::vector<Polygon>& polygons)
{
  Trimmer trimmer(complex, polygons);
  trimmer.removePieces();
  trimmer.separateSheets();
  trimmer.removePieces();
  polygons = trimmer.result();
  return trimmer.gone();
}
}
