// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SheetTriangles_h
#define medial_SheetTriangles_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/DisjointSets.h"
#include "Measuring/SheetWidths.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace medial
{
/// Of a plate's axis, in squares of its thickness. The axis of a sheet is narrower than the solid by one
/// thickness. Where three rods of a frame meet they make sheets of up to 1.2.
constexpr double leastPlateArea = 1.5;

/// The triangles of an axis, and which of them are plates and fins of plates.
struct SheetTriangles
{
  SheetTriangles(const MedialAxis& medialAxis, const AxisEdges& axisEdges,
    const SheetWidths& sheetWidths, double plateRatio)
    : axis(medialAxis)
    , triangles(medialAxis.cells.triangles)
    , edges(axisEdges)
    , plate(triangles.size(), 0)
    , fin(triangles.size(), 0)
  {
    for (Index t = 0; t < count(this->triangles); ++t)
    {
      int wide = 0;
      double radii = 0;
      for (const Index p : this->triangles[t])
      {
        wide += sheetWidths.ratio[p] > plateRatio;
        radii += this->axis.radii[p];
      }
      this->plate[t] = wide >= 2;
      this->radius.push_back(radii / 3);
      this->area.push_back(triangleArea(this->axis, this->triangles[t]));
      this->time.push_back(
        radii / 3 + this->axis.cellErosion[this->axis.cells.firstTriangle() + t]);
    }
  }

  /// What the triangles of each set, known by the lowest one, have together.
  struct Sums
  {
    std::vector<double> area;      ///< without fins
    std::vector<double> thickness; ///< the largest one
    double spacing;                ///< of the samples, which tell nothing of what is smaller

    /// Is it too small for a plate?
    bool isSmall(Index set) const
    {
      const double side = std::max(thickness[set], spacing);
      return area[set] <= leastPlateArea * side * side;
    }
  };

  Sums sumsOf(DisjointSets& sets) const
  {
    Sums sums{ std::vector<double>(this->triangles.size(), 0),
      std::vector<double>(this->triangles.size(), 0), this->axis.sampleSpacing };
    for (Index t = 0; t < count(this->triangles); ++t)
    {
      if (!this->fin[t])
      {
        const Index set = sets.find(t);
        sums.area[set] += this->area[t];
        sums.thickness[set] = std::max(sums.thickness[set], 2 * this->radius[t]);
      }
    }
    return sums;
  }

  /// Links the triangles with the same key at each edge to the one of them that burns last: calls
  /// body(triangle, triangle). Pairs would be too many where very many sheets meet.
  /// @param key  None: the triangle is left alone
  template <typename Key, typename Body>
  void forLinks(const Key& key, const Body& body) const
  {
    std::vector<std::tuple<Index, double, Index>> at;
    for (Index e = 0; e < count(this->edges.points); ++e)
    {
      at.clear();
      for (const Index t : this->edges.triangles[e])
      {
        at.push_back({ key(t), -this->time[t], t });
      }
      std::sort(at.begin(), at.end());
      std::size_t top = 0;
      for (std::size_t i = 1; i < at.size(); ++i)
      {
        top = std::get<0>(at[i]) == std::get<0>(at[top]) ? top : i;
        if (i != top && std::get<0>(at[i]) != None)
        {
          body(std::get<2>(at[top]), std::get<2>(at[i]));
        }
      }
    }
  }

  const MedialAxis& axis;
  const std::vector<Triangle>& triangles;
  const AxisEdges& edges;
  std::vector<double> radius, area, time; ///< of each triangle; the time when it has burnt
  std::vector<char> plate, fin;
};
}

#endif
