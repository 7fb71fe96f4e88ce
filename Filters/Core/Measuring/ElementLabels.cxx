// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/ElementLabels.h"

#include "Base/DisjointSets.h"
#include "Measuring/RodLabels.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{
class Labelling
{
public:
  Labelling(const MedialAxis& medialAxis, const AxisEdges& axisEdges,
    const PlatePieces& platePieces, const RodCells& rodCells, const RodBranches& rodBranches,
    const Execution& run)
    : axis(medialAxis)
    , edges(axisEdges)
    , plates(platePieces)
    , rods(rodCells)
    , branches(rodBranches)
    , execution(run)
  {
    this->labelPoints();
    this->labelCells();
    this->renumber();
    this->labelPlatePoints();
  }

  ElementLabels result() { return std::move(this->all); }

private:
  /// Labels are numbers of elements: plates, rods, then pieces without a curve. Pieces of rods in
  /// which no curve is left go to the plates that they touch.
  void labelPoints()
  {
    std::vector<LabelSeed> seeds;
    for (Index rod = 0; rod < this->branches.points.size(); ++rod)
    {
      for (const Index p : this->branches.points[rod])
      {
        seeds.push_back({ p, this->plates.count + rod });
      }
    }
    const Index pointCount = count(this->axis.points);
    DisjointSets pieces(pointCount);
    for (Index e = 0; e < count(this->edges.points); ++e)
    {
      if (this->rods.edges[e])
      {
        pieces.unite(this->edges.points[e][0], this->edges.points[e][1]);
      }
    }
    std::vector<char> hasSeed(pointCount, 0);
    for (const LabelSeed& seed : seeds)
    {
      hasSeed[pieces.find(seed.point)] = 1;
    }
    for (Index p = 0; p < pointCount; ++p)
    {
      if (this->rods.points[p] && this->rods.plateAt[p] != None && !hasSeed[pieces.find(p)])
      {
        seeds.push_back({ p, this->rods.plateAt[p] });
      }
    }
    this->all.ofPoint =
      nearestLabels(this->axis, this->edges, this->rods.edges, seeds, this->execution);
    std::vector<Index> ofPiece(pointCount, None);
    Index next = this->plates.count + this->branches.points.size();
    for (Index p = 0; p < pointCount; ++p)
    {
      Index& label = this->all.ofPoint[p];
      if (this->rods.points[p] && label == None)
      {
        Index& piece = ofPiece[pieces.find(p)];
        piece = piece == None ? next++ : piece;
        label = piece;
      }
    }
    this->labelCount = next;
  }

  /// A cell of a rod has the label of most of its corners, or of the first.
  void labelCells()
  {
    const AxisCells& cells = this->axis.cells;
    const std::vector<Index>& ofPoint = this->all.ofPoint;
    for (const Index p : cells.vertices)
    {
      this->all.ofCell.push_back(ofPoint[p]);
    }
    for (const auto& [a, b] : cells.edges)
    {
      this->all.ofCell.push_back(std::min(ofPoint[a], ofPoint[b]));
    }
    for (Index t = 0; t < count(cells.triangles); ++t)
    {
      const auto& [a, b, c] = cells.triangles[t];
      const Index label = ofPoint[b] == ofPoint[c] ? ofPoint[b] : ofPoint[a];
      this->all.ofCell.push_back(
        this->plates.ofTriangle[t] == None ? label : this->plates.ofTriangle[t]);
    }
  }

  /// Gives elements that have cells their final numbers.
  void renumber()
  {
    std::vector<Index> number(this->labelCount, None);
    std::vector<Element>& elements = this->all.elements;
    const auto give = [&](Index label) {
      if (number[label] == None)
      {
        number[label] = count(elements);
        elements.emplace_back();
        elements.back().isPlate = label < this->plates.count;
        const Index rod = label - this->plates.count;
        if (rod >= 0 && rod < this->branches.points.size())
        {
          elements.back().length = this->branches.length[rod];
        }
      }
    };
    for (Index plate = 0; plate < this->plates.count; ++plate)
    {
      give(plate);
    }
    for (Index& label : this->all.ofCell)
    {
      give(label);
      label = number[label];
    }
    for (Index& label : this->all.ofPoint)
    {
      label = label == None ? None : number[label];
    }
    for (Index rod = 0; rod < this->branches.points.size(); ++rod)
    {
      this->all.ofRod.push_back(number[this->plates.count + rod]);
    }
  }

  /// A point at plates belongs to the one whose triangle at it burns last.
  void labelPlatePoints()
  {
    std::vector<double> last(this->axis.points.size(), -1);
    const Index first = this->axis.cells.firstTriangle();
    for (Index t = 0; t < count(this->axis.cells.triangles); ++t)
    {
      const double erosion = this->axis.cellErosion[first + t];
      for (const Index p : this->axis.cells.triangles[t])
      {
        if (this->plates.ofTriangle[t] != None && erosion > last[p])
        {
          last[p] = erosion;
          this->all.ofPoint[p] = this->plates.ofTriangle[t];
        }
      }
    }
  }

  const MedialAxis& axis;
  const AxisEdges& edges;
  const PlatePieces& plates;
  const RodCells& rods;
  const RodBranches& branches;
  const Execution& execution;
  ElementLabels all;
  Index labelCount = 0;
};
}

ElementLabels elementLabels(const MedialAxis& axis, const AxisEdges& edges,
  const PlatePieces& plates, const RodCells& rods, const RodBranches& branches,
  const Execution& execution)
{
  return Labelling(axis, edges, plates, rods, branches, execution).result();
}
}
