// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/PlatePieces.h"

#include "Base/DisjointSets.h"
#include "Base/Lists.h"
#include "Measuring/PointVolumes.h"
#include "Measuring/SheetMerging.h"
#include "Measuring/SheetTriangles.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{
/// The border of a piece with a neighbour.
struct Border
{
  Index from, to;
  double length;
};

/// Steps 1 to 3.
class Cutter
{
public:
  Cutter(SheetTriangles& sheetTriangles, double plateRatio)
    : all(sheetTriangles)
    , leastRatio(plateRatio)
    , sheets(count(sheetTriangles.triangles))
    , pieces(count(sheetTriangles.triangles))
  {
  }

  /// Step 1.
  /// @param volumes  of the points
  void dropMeetings(const std::vector<double>& volumes)
  {
    DisjointSets groups(count(this->all.triangles)), bodies(count(this->all.axis.points));
    this->all.forLinks([this](Index t) { return this->all.plate[t] ? 0 : None; },
      [&](Index a, Index b) { groups.unite(a, b); });
    for (const Edge& ends : this->all.edges.points)
    {
      bodies.unite(ends[0], ends[1]);
    }
    const SheetTriangles::Sums sums = this->all.sumsOf(groups);
    const std::vector<Index> groupAt = this->groupsAtPoints(groups);
    std::vector<double> ofBody(volumes.size(), 0), ofGroup(this->all.triangles.size(), 0);
    for (Index p = 0; p < count(volumes); ++p)
    {
      ofBody[bodies.find(p)] += volumes[p];
      if (groupAt[p] != None)
      {
        ofGroup[groupAt[p]] += volumes[p];
      }
    }
    for (Index t = 0; t < count(this->all.triangles); ++t)
    {
      const Index group = groups.find(t);
      const double whole = ofBody[bodies.find(this->all.triangles[t][0])];
      this->all.plate[t] =
        this->all.plate[t] && !(sums.isSmall(group) && 2 * ofGroup[group] < whole);
    }
  }

  /// Step 2.
  void cutAtSeams(const Execution& execution)
  {
    const std::vector<char> onSeam = this->seamPoints();
    for (Index e = 0; e < count(this->all.edges.points); ++e)
    {
      const IndexLists::View at = this->all.edges.triangles[e];
      const auto [a, b] = this->all.edges.points[e];
      if (at.size() == 2 && this->all.plate[at[0]] && this->all.plate[at[1]] &&
        !(onSeam[a] && onSeam[b]))
      {
        this->sheets.unite(at[0], at[1]);
      }
    }
    std::vector<char> stands(this->all.triangles.size(), 0);
    for (Index t = 0; t < count(this->all.triangles); ++t)
    {
      stands[this->sheets.find(t)] |= this->all.time[t] > this->leastRatio * this->all.radius[t];
    }
    for (Index t = 0; t < count(this->all.triangles); ++t)
    {
      this->all.fin[t] = !stands[this->sheets.find(t)];
    }
    mergeByBonds(this->sheets, this->bonds(), execution);
  }

  /// Step 3: floods each sheet from its summits down. Where two floods meet, they become one unless a
  /// neck is there.
  void cutAtNecks(double neckRatio)
  {
    std::vector<std::pair<double, Edge>> valleys;
    this->all.forLinks([this](Index t) { return this->all.plate[t] ? this->sheets.find(t) : None; },
      [&](Index a, Index b) {
        valleys.push_back({ -std::min(this->all.time[a], this->all.time[b]), { a, b } });
      });
    std::sort(valleys.begin(), valleys.end());
    std::vector<double> summit = this->all.time; // of each piece, by its lowest triangle
    for (const auto& [depth, sides] : valleys)
    {
      const Index a = this->pieces.find(sides[0]), b = this->pieces.find(sides[1]);
      if (a != b && -depth >= neckRatio * std::min(summit[a], summit[b]))
      {
        this->pieces.unite(a, b);
        summit[this->pieces.find(a)] = std::max(summit[a], summit[b]);
      }
    }
  }

  /// The plates by their triangles; of no use where there is no plate.
  const DisjointSets& result() const { return this->pieces; }

private:
  /// For each point: does it lie on an edge with more than two triangles? An edge between two such points
  /// may be a gap in a seam.
  std::vector<char> seamPoints() const
  {
    std::vector<char> result(this->all.axis.points.size(), 0);
    for (Index e = 0; e < count(this->all.edges.points); ++e)
    {
      if (this->all.edges.triangles[e].size() > 2)
      {
        result[this->all.edges.points[e][0]] = result[this->all.edges.points[e][1]] = 1;
      }
    }
    return result;
  }

  /// Edges at which exactly two triangles of plates are left without fins bind these; those with more
  /// speak against it. So a seam stays one where the third sheet has a gap.
  std::vector<Bond> bonds()
  {
    std::vector<Bond> result;
    std::vector<Index> at;
    for (Index e = 0; e < count(this->all.edges.points); ++e)
    {
      at.clear();
      for (const Index t : this->all.edges.triangles[e])
      {
        if (this->all.plate[t] && !this->all.fin[t])
        {
          at.push_back(t);
        }
      }
      const Edge& ends = this->all.edges.points[e];
      const double length =
        (this->all.axis.points[ends[0]] - this->all.axis.points[ends[1]]).norm();
      // Not all pairs, where there are very many.
      for (std::size_t i = 0; i < at.size(); ++i)
      {
        for (std::size_t k = i + 1; k < std::min(at.size(), i + 4); ++k)
        {
          result.push_back({ at[i], at[k], at.size() == 2 ? length : -length });
        }
      }
    }
    return result;
  }

  /// For each point the lowest group of plate triangles at it, or None.
  std::vector<Index> groupsAtPoints(DisjointSets& groups)
  {
    std::vector<Index> result(this->all.axis.points.size(), None);
    for (Index t = count(this->all.triangles) - 1; t >= 0; --t)
    {
      for (const Index p : this->all.triangles[t])
      {
        result[p] = this->all.plate[t] ? groups.find(t) : result[p];
      }
    }
    return result;
  }

  SheetTriangles& all;
  double leastRatio;
  DisjointSets sheets;
  DisjointSets pieces;
};

/// Step 4.
class Joining
{
public:
  Joining(const SheetTriangles& sheetTriangles, DisjointSets cutPieces)
    : all(sheetTriangles)
    , pieces(std::move(cutPieces))
  {
  }

  /// Each small piece joins one neighbour; again while there are small ones that have some. The
  /// number of these halves each time.
  void joinSmall(const Execution& execution)
  {
    bool joined = true;
    while (joined)
    {
      execution.poll();
      joined = false;
      const SheetTriangles::Sums sums = this->all.sumsOf(this->pieces);
      std::vector<Border> borders = this->bordersOfSmall(sums);
      for (std::size_t i = 0; i < borders.size();)
      {
        const Index from = borders[i].from;
        Border longest = borders[i];
        for (; i < borders.size() && borders[i].from == from; ++i)
        {
          longest = borders[i].length > longest.length ? borders[i] : longest;
        }
        joined = this->pieces.unite(from, longest.to) || joined;
      }
    }
  }

  PlatePieces result()
  {
    PlatePieces result;
    result.isFin = this->all.fin;
    result.ofTriangle.assign(this->all.triangles.size(), None);
    std::vector<Index> number(this->all.triangles.size(), None);
    for (Index t = 0; t < count(this->all.triangles); ++t)
    {
      if (this->all.plate[t])
      {
        Index& piece = number[this->pieces.find(t)];
        piece = piece == None ? result.count++ : piece;
        result.ofTriangle[t] = piece;
      }
    }
    return result;
  }

private:
  /// The borders of small pieces and fins, by piece and neighbour, with their lengths. Where many pieces
  /// meet at an edge each has two neighbours.
  std::vector<Border> bordersOfSmall(const SheetTriangles::Sums& sums)
  {
    std::vector<Border> borders;
    std::vector<Index> at;
    for (Index e = 0; e < count(this->all.edges.points); ++e)
    {
      at.clear();
      for (const Index t : this->all.edges.triangles[e])
      {
        if (this->all.plate[t])
        {
          at.push_back(this->pieces.find(t));
        }
      }
      sortUnique(at);
      const Edge& ends = this->all.edges.points[e];
      const double length =
        (this->all.axis.points[ends[0]] - this->all.axis.points[ends[1]]).norm();
      for (std::size_t i = 0; at.size() > 1 && i < at.size(); ++i)
      {
        if (sums.isSmall(at[i]))
        {
          borders.push_back({ at[i], at[(i + 1) % at.size()], length });
          borders.push_back({ at[i], at[(i + at.size() - 1) % at.size()], length });
        }
      }
    }
    return summed(std::move(borders));
  }

  /// One border for each piece and neighbour.
  static std::vector<Border> summed(std::vector<Border> borders)
  {
    std::stable_sort(borders.begin(), borders.end(), [](const Border& a, const Border& b) {
      return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
    std::vector<Border> result;
    for (const Border& border : borders)
    {
      if (result.empty() || result.back().from != border.from || result.back().to != border.to)
      {
        result.push_back({ border.from, border.to, 0 });
      }
      result.back().length += border.length;
    }
    return result;
  }

  const SheetTriangles& all;
  DisjointSets pieces;
};
}

PlatePieces platePieces(const MedialAxis& axis, const AxisEdges& edges, const SheetWidths& widths,
  double plateRatio, double neckRatio, const Execution& execution)
{
  SheetTriangles triangles(axis, edges, widths, plateRatio);
  Cutter cutter(triangles, plateRatio);
  cutter.dropMeetings(pointVolumes(axis));
  execution.poll();
  cutter.cutAtSeams(execution);
  execution.poll();
  cutter.cutAtNecks(neckRatio);
  Joining joining(triangles, cutter.result());
  joining.joinSmall(execution);
  return joining.result();
}
}
