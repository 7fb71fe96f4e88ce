// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/SheetSeparation.h"

#include <algorithm>
#include <numeric>
#include <utility>

// A seam is a side where three sheets meet. Two sheets are connected around the end of the third one
// if a walk around an end of the seam leads from one to the other, over sides with exactly two faces in
// sheets. A cut along this walk takes one face at a time, so that the topology stays, and pieces are
// found again after each round, because a collapse makes new borders and so new slivers.
//
// With s seams, each round takes time linear in the faces, and a walk takes time quadratic in the faces
// at one vertex, of which there are few. Each round but the last collapses a face.

namespace medial
{
namespace
{
/// Of a walk over faces.
struct Step
{
  Index face, before; ///< and the step it was reached from
};

std::vector<Index> pathTo(Index step, const std::vector<Step>& steps)
{
  std::vector<Index> path;
  for (; step != None; step = steps[step].before)
  {
    path.push_back(steps[step].face);
  }
  return path;
}

/// The radius of the maximal ball at a corner of a face.
double radiusAt(const FaceComplex& faces, const FaceGeometry& geometry, Index polygon, Index vertex)
{
  const Index edge = faces.polygons[polygon].siteEdge;
  if (edge == None)
  {
    return 0;
  }
  return (geometry.points[vertex] - geometry.sites[geometry.siteEdges[edge][0]]).norm();
}

/// The mean radius of the maximal balls at all corners: how deep in the solid the face is.
double meanRadius(const FaceComplex& faces, const FaceGeometry& geometry, Index polygon)
{
  const std::vector<Index>& corners = faces.polygons[polygon].corners;
  const double sum = std::accumulate(corners.begin(), corners.end(), 0.0,
    [&](double part, Index v) { return part + radiusAt(faces, geometry, polygon, v); });
  return sum / count(corners);
}

class Separation
{
public:
  Separation(FaceComplex& faceComplex, const FaceGeometry& faceGeometry)
    : faces(faceComplex)
    , geometry(faceGeometry)
    , sheets(faceComplex, faceGeometry)
    , reachedIn(faceComplex.polygons.size(), 0)
  {
  }

  void run()
  {
    // Candidates, slivers included: what turns at a side never changes, so no other side gets a seam.
    std::vector<Index> seams;
    for (Index s = 0; s < this->faces.sideCount(); ++s)
    {
      if (this->faces.faceCount(s) > 2 && this->sheets.isTripod(s, this->faces.facesAt(s)))
      {
        seams.push_back(s);
      }
    }
    for (bool changed = true; changed;)
    {
      changed = false;
      this->sheets.findSheets();
      for (const Index s : seams)
      {
        for (const Index v : this->faces.ends(s))
        {
          while (this->sheets.isSeam(s) && this->separate(s, v))
          {
            changed = true;
          }
        }
      }
    }
  }

private:
  /// Takes a face away from between two sheets of a seam that are one around its end.
  bool separate(Index seam, Index vertex)
  {
    const std::vector<Index> at = this->sheets.sheetsAt(seam);
    for (std::size_t i = 0; i < at.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (this->sheets.turns(seam, at[i], at[j]))
        {
          const std::vector<Index> path = this->around(seam, vertex, at[i], at[j]);
          if (!path.empty())
          {
            return this->cut(path, vertex);
          }
        }
      }
    }
    return false;
  }

  /// The faces that lead around an end of a seam, over sides with two faces in sheets, from one face at the
  /// seam to another, both included; none where there is no way. The end is a vertex, and the first few that
  /// sides with more faces in sheets, which are no seams, connect with it.
  std::vector<Index> around(Index seam, Index vertex, Index from, Index to)
  {
    std::vector<Index> end{ vertex };
    std::vector<Step> steps{ { from, None } };
    for (std::size_t known = 0; known < end.size();)
    {
      known = end.size();
      for (Index i = 0; i < count(steps); ++i)
      {
        if (steps[i].face == to)
        {
          return pathTo(i, steps);
        }
        this->step(seam, i, steps, end);
      }
    }
    return {};
  }

  /// At the corners of boxes 4 are too few, and more do not help. On a bumpy sphere ends of any length take quadratic time.
  static constexpr Index largestEnd = 8;

  /// Appends the faces that are next to one at the end of a seam, and vertices that belong to the end.
  void step(Index seam, Index from, std::vector<Step>& steps, std::vector<Index>& end)
  {
    const auto isIn = [&end](Index v) { return std::find(end.begin(), end.end(), v) != end.end(); };
    for (const Index s : this->faces.sidesOf(steps[from].face))
    {
      const Edge& ends = this->faces.ends(s);
      const bool first = isIn(ends[0]), second = isIn(ends[1]);
      if (s == seam || (!first && !second))
      {
        continue;
      }
      const std::vector<Index> at = this->sheets.sheetsAt(s);
      if (first != second && count(end) < largestEnd && at.size() > 2 &&
        !this->sheets.isTripod(s, at))
      {
        end.push_back(first ? ends[1] : ends[0]);
      }
      for (const Index q : at.size() == 2 ? at : std::vector<Index>{})
      {
        const auto isQ = [q](const Step& step) { return step.face == q; };
        if (std::none_of(steps.begin(), steps.end(), isQ))
        {
          steps.push_back({ q, from });
        }
      }
    }
  }

  /// Collapses the nearest face with a free side to a path around a vertex, in its ball; of several the
  /// shallowest. The ends of the path are at the seam: they count only if there are no others.
  bool cut(const std::vector<Index>& path, Index vertex)
  {
    const double reach = std::max(radiusAt(this->faces, this->geometry, path.front(), vertex),
      radiusAt(this->faces, this->geometry, path.back(), vertex));
    std::vector<Index> reached = path;
    if (path.size() > 2)
    {
      reached.assign(path.begin() + 1, path.end() - 1);
    }
    ++this->walks;
    for (const Index p : reached)
    {
      this->reachedIn[p] = this->walks;
    }
    for (std::size_t begin = 0; begin < reached.size();)
    {
      const std::size_t end = reached.size();
      Index best = None;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index p = reached[i];
        if (this->faces.freeSide(p) != None &&
          (best == None ||
            meanRadius(this->faces, this->geometry, p) <
              meanRadius(this->faces, this->geometry, best)))
        {
          best = p;
        }
      }
      if (best != None)
      {
        return this->faces.collapse(best);
      }
      for (; begin < end; ++begin)
      {
        this->reachNext(reached[begin], vertex, reach, reached);
      }
    }
    return false;
  }

  /// Appends the faces next to one that have a corner near a vertex.
  void reachNext(Index face, Index vertex, double reach, std::vector<Index>& reached)
  {
    const auto isNear = [&](Index v) {
      return (this->geometry.points[v] - this->geometry.points[vertex]).norm() < reach;
    };
    for (const Index s : this->faces.sidesOf(face))
    {
      if (this->faces.faceCount(s) != 2)
      {
        continue;
      }
      this->faces.forFacesAt(s, [&](Index q) {
        const std::vector<Index>& corners = this->faces.polygons[q].corners;
        if (this->reachedIn[q] != this->walks &&
          std::any_of(corners.begin(), corners.end(), isNear))
        {
          this->reachedIn[q] = this->walks;
          reached.push_back(q);
        }
      });
    }
  }

  FaceComplex& faces;
  const FaceGeometry& geometry;
  Sheets sheets;
  std::vector<Index> reachedIn; ///< for each face the last walk of cut() that reached it
  Index walks = 0;
};
}

void separateSheets(FaceComplex& faces, const FaceGeometry& geometry)
{
  Separation(faces, geometry).run();
}
}
