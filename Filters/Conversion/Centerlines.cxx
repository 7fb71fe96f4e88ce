// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Centerlines.h"

#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Cells.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{
/// The points of all branches, each once, and the branches on them.
struct Polylines
{
  std::vector<Point> points;
  std::vector<double> radii;
  std::vector<std::vector<Index>> lines;
};

Polylines polylines(const Centerlines& lines)
{
  Polylines result;
  for (const CenterlineNode& node : lines.nodes)
  {
    result.points.push_back(node.point);
    result.radii.push_back(node.radius);
  }
  for (const Centerline& branch : lines.branches)
  {
    const auto [first, last] = branch.nodes;
    const Index firstNew = count(result.points);
    std::vector<Index> line;
    for (Index i = 0; i < count(branch.points); ++i)
    {
      const bool isFirst = i == 0, isLast = i + 1 == count(branch.points);
      if (isLast)
      {
        line.push_back(last == None ? firstNew : last);
      }
      else if (isFirst && first != None)
      {
        line.push_back(first);
      }
      else
      {
        line.push_back(count(result.points));
        result.points.push_back(branch.points[i]);
        result.radii.push_back(branch.radii[i]);
      }
    }
    result.lines.push_back(std::move(line));
  }
  return result;
}

/// The mean along a branch.
double meanRadius(const Centerline& branch)
{
  const std::vector<double> at = lengths(branch.points);
  double sum = 0;
  for (std::size_t i = 1; i < at.size(); ++i)
  {
    sum += (at[i] - at[i - 1]) * (branch.radii[i] + branch.radii[i - 1]) / 2;
  }
  return at.back() > 0 ? sum / at.back() : branch.radii.front();
}

template <typename Values>
std::vector<Index> numbersOf(const Values& values)
{
  std::vector<Index> result(values.size());
  std::iota(result.begin(), result.end(), 0);
  return result;
}

void addBranches(const std::vector<Centerline>& branches, vtkCellData* cells)
{
  add<vtkIdTypeArray>(cells, names::BranchId, numbersOf(branches));
  cells->AddArray(tuples<vtkIdTypeArray>(
    names::BranchNodes, 2, branches, [](const Centerline& branch) { return branch.nodes; }));
  add<vtkDoubleArray>(cells, names::Length, branches,
    [](const Centerline& branch) { return lengths(branch.points).back(); });
  add<vtkDoubleArray>(cells, names::MeanRadius, branches, meanRadius);
  add<vtkDoubleArray>(cells, names::MinimumRadius, branches, [](const Centerline& branch) {
    return *std::min_element(branch.radii.begin(), branch.radii.end());
  });
}
}

void write(const Centerlines& lines, vtkPolyData* axis, vtkPolyData* output, vtkPolyData* nodes)
{
  output->GetFieldData()->PassData(axis->GetFieldData());
  for (const char* ofBalls : { names::BallOwner, names::BallVolume, names::BallPoleVolume })
  {
    output->GetFieldData()->RemoveArray(ofBalls);
  }
  const Polylines all = polylines(lines);
  output->SetPoints(points(all.points));
  output->SetLines(cellArray(all.lines));
  add<vtkDoubleArray>(output->GetPointData(), names::MaximumInscribedSphereRadius, all.radii);
  output->GetPointData()->SetActiveScalars(names::MaximumInscribedSphereRadius);
  addBranches(lines.branches, output->GetCellData());
  addOne<vtkIdTypeArray>(output->GetFieldData(), names::OpenedVoids, lines.openedVoids);

  nodes->SetPoints(points(lines.nodes, [](const CenterlineNode& node) { return node.point; }));
  nodes->SetVerts(vertexForEach(count(lines.nodes)));
  vtkPointData* data = nodes->GetPointData();
  add<vtkIdTypeArray>(data, names::NodeId, numbersOf(lines.nodes));
  add<vtkDoubleArray>(
    data, names::MaximumInscribedSphereRadius, lines.nodes, &CenterlineNode::radius);
  add<vtkIdTypeArray>(data, names::Degree, lines.nodes, &CenterlineNode::degree);
  add<vtkUnsignedCharArray>(data, names::AtPlate, lines.nodes, &CenterlineNode::isAtPlate);
}
}
