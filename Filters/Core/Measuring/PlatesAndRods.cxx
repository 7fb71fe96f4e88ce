// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/PlatesAndRods.h"

#include "Axis/AxisEdges.h"
#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Measuring/BurnTimes.h"
#include "Measuring/CoveringBalls.h"
#include "Measuring/ElementLabels.h"
#include "Measuring/PlatePieces.h"
#include "Measuring/RodBranches.h"
#include "Measuring/RodCells.h"
#include "Measuring/RodSkeleton.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace medial
{
namespace
{
/// Puts plates and rods together, and counts where they meet.
class Assembly
{
public:
  Assembly(const MedialAxis& medialAxis, const AxisEdges& axisEdges, const PlatePieces& platePieces,
    const std::vector<double>& times, const std::vector<Index>& covering, const Execution& run)
    : axis(medialAxis)
    , edges(axisEdges)
    , plates(platePieces)
    , rods(rodCells(medialAxis, axisEdges, platePieces))
    , branches(rodBranches(medialAxis,
        rodSkeleton(medialAxis, axisEdges, times, rods.triangles, rods.anchor, covering, run),
        rods.anchor, covering))
  {
    ElementLabels labels = elementLabels(axis, edges, plates, rods, branches, run);
    this->all.elementOfPoint = std::move(labels.ofPoint);
    this->all.elementOfCell = std::move(labels.ofCell);
    this->all.elements = std::move(labels.elements);
    this->elementOfRod = std::move(labels.ofRod);
  }

  PlatesAndRods result()
  {
    this->addJunctions();
    this->addContacts();
    this->countSeams();
    sortUnique(this->contacts);
    PlatesAndRods& all = this->all;
    all.neighbors = listsByKey(count(all.elements), [this](const auto& add) {
      for (const auto& [from, to] : this->contacts)
      {
        add(from, to);
      }
    });
    measure(
      this->axis, this->sharersOfPoints(), all.elementOfCell, this->plates.isFin, all.elements);
    return std::move(all);
  }

private:
  /// All of these elements meet.
  void addMeeting(std::vector<Index> elements)
  {
    sortUnique(elements);
    constexpr std::size_t few = 16; // all pairs would be too many where very many meet
    for (std::size_t i = elements.front() == None ? 1 : 0; i < std::min(few, elements.size()); ++i)
    {
      for (std::size_t k = i + 1; k < elements.size(); ++k)
      {
        const Index a = elements[i], b = elements[k];
        this->contacts.insert(this->contacts.end(), { { a, b }, { b, a } });
      }
    }
  }

  void addJunctions()
  {
    for (Index junction = 0; junction < this->branches.rodsAtJunction.size(); ++junction)
    {
      const IndexLists::View anchors = this->branches.anchorsAtJunction[junction];
      (anchors.size() > 0 ? this->all.mixedJunctions : this->all.rodJunctions) += 1;
      std::vector<Index> elements;
      for (const Index rod : this->branches.rodsAtJunction[junction])
      {
        elements.push_back(this->elementOfRod[rod]);
      }
      for (const Index p : anchors)
      {
        elements.push_back(this->rods.plateAt[p]);
      }
      this->addMeeting(std::move(elements));
    }
  }

  /// The rods of a junction share the volume of the points in it; all other points have one element.
  IndexLists sharersOfPoints() const
  {
    std::vector<Index> junctionAt(this->axis.points.size(), None);
    for (Index junction = 0; junction < this->branches.pointsAtJunction.size(); ++junction)
    {
      for (const Index p : this->branches.pointsAtJunction[junction])
      {
        junctionAt[p] = this->rods.plateAt[p] == None ? junction : None;
      }
    }
    IndexLists result;
    for (Index p = 0; p < count(this->axis.points); ++p)
    {
      if (junctionAt[p] != None)
      {
        for (const Index rod : this->branches.rodsAtJunction[junctionAt[p]])
        {
          const Index element = this->elementOfRod[rod];
          result.items.push_back(element == None ? this->all.elementOfPoint[p] : element);
        }
      }
      else if (this->all.elementOfPoint[p] != None)
      {
        result.items.push_back(this->all.elementOfPoint[p]);
      }
      result.close();
    }
    return result;
  }

  /// Elements whose cells share a point are neighbours.
  void addContacts()
  {
    const IndexLists elementsAt = listsByKey(count(this->axis.points), [this](const auto& add) {
      for (Index cell = 0; cell < this->axis.cells.size(); ++cell)
      {
        forPoints(this->axis.cells, cell, [&](Index p) { add(p, this->all.elementOfCell[cell]); });
      }
    });
    for (Index p = 0; p < elementsAt.size(); ++p)
    {
      if (elementsAt[p].size() > 1)
      {
        this->addMeeting({ elementsAt[p].begin(), elementsAt[p].end() });
      }
    }
  }

  /// Edges at which plates meet, so many as do not hang together.
  void countSeams()
  {
    DisjointSets seams(count(this->axis.points));
    std::vector<char> onSeam(this->axis.points.size(), 0);
    for (Index e = 0; e < count(this->edges.points); ++e)
    {
      Index first = None;
      for (const Index t : this->edges.triangles[e])
      {
        const Index plate = this->plates.ofTriangle[t];
        if (plate != None && first != None && plate != first)
        {
          const auto [a, b] = this->edges.points[e];
          seams.unite(a, b);
          onSeam[a] = onSeam[b] = 1;
        }
        first = first == None ? plate : first;
      }
    }
    for (Index p = 0; p < count(onSeam); ++p)
    {
      this->all.plateJunctions += onSeam[p] && seams.find(p) == p;
    }
  }

  const MedialAxis& axis;
  const AxisEdges& edges;
  const PlatePieces& plates;
  const RodCells rods;
  const RodBranches branches;
  PlatesAndRods all;
  std::vector<Index> elementOfRod; ///< or None: it has no cell of its own
  std::vector<Edge> contacts;      ///< in both directions
};

void check(const PlatesAndRodsOptions& options)
{
  if (!(options.plateRatio >= 1) || !std::isfinite(options.plateRatio))
  {
    throw InvalidInput("the ratio of width to thickness from which on a sheet is a plate is ",
      options.plateRatio, ": take a number from 1 on, such as 1.5");
  }
  if (!(options.neckRatio >= 0 && options.neckRatio <= 1))
  {
    throw InvalidInput("the part of its width to which a plate narrows at a neck is ",
      options.neckRatio, ": take a number from 0 to 1, such as 0.8");
  }
}
}

PlatesAndRods platesAndRods(
  const MedialAxis& axis, const PlatesAndRodsOptions& options, const Execution& execution)
{
  check(options);
  const AxisEdges edges = axisEdges(axis.cells);
  execution.report(0.1);
  const std::vector<double> times = burnTimes(axis);
  SheetWidths widths = sheetWidths(axis, edges, times, execution);
  execution.report(0.2);
  const PlatePieces plates =
    platePieces(axis, edges, widths, options.plateRatio, options.neckRatio, execution);
  execution.report(0.5);
  const std::vector<Index> covering = coveringBalls(axis, edges, execution);
  PlatesAndRods result = Assembly(axis, edges, plates, times, covering, execution).result();
  result.widths = std::move(widths);
  execution.report(1);
  return result;
}
}
