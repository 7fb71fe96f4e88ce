// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Surface.h"

#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Balls.h"
#include "Conversion/Cells.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace medial
{
namespace
{
void addField(const ProvenSamples& made, const ClosedSurface& surface, vtkFieldData* field)
{
  addBetti(field, names::BettiSolid, surface.measures.betti);
  addOne<vtkDoubleArray>(field, names::SolidVolume, surface.measures.volume);
  addOne<vtkDoubleArray>(field, names::SolidArea, surface.area);
  addOne<vtkIdTypeArray>(field, names::MergedPoints, surface.repairs.mergedPoints);
  addOne<vtkIdTypeArray>(field, names::DroppedPolygons, surface.repairs.droppedPolygons);
  addOne<vtkIdTypeArray>(field, names::FilledHoles, surface.repairs.filledHoles);
  addOne<vtkIdTypeArray>(field, names::RefinementRounds, made.rounds);
}
}

ClosedSurface readSurface(
  vtkPointSet* input, const std::optional<WrapOptions>& wrap, const Execution& execution)
{
  const std::vector<Point> points = readFinitePoints(input, "mend the file that they come from");
  const IndexLists polygons = readPolygons(input);
  try
  {
    return closedSurface(points, polygons, execution.between(0, wrap ? 0.3 : 1));
  }
  catch (const InvalidInput&)
  {
    if (!wrap)
    {
      throw;
    }
  }
  return wrappedSurface(points, polygons, *wrap, execution.between(0.3, 1));
}

Solid readSolid(vtkPolyData* input, const Execution& execution)
{
  // What vtkBoundarySamples gives is right already.
  const std::vector<Point> points = readFinitePoints(input, "mend the file that they come from");
  const IndexLists polygons = readPolygons(input);
  std::vector<Triangle> triangles;
  for (Index i = 0; i < polygons.size() && polygons[i].size() == 3; ++i)
  {
    triangles.push_back({ polygons[i][0], polygons[i][1], polygons[i][2] });
  }
  if (count(triangles) == polygons.size() && !triangles.empty())
  {
    const SolidMeasures measures = solidMeasures(points, triangles, execution);
    if (measures.closed && measures.manifold && measures.volume > 0)
    {
      return { SurfaceTree(points, triangles), measures.betti };
    }
  }
  const ClosedSurface surface = closedSurface(points, polygons, execution);
  return { SurfaceTree(surface.points, surface.triangles), surface.measures.betti };
}

void write(const ProvenSamples& made, const ClosedSurface& surface, vtkPointSet* input,
  vtkPolyData* samples, vtkPolyData* closed)
{
  const std::vector<SurfacePoint>& all = made.samples.points;
  samples->SetPoints(points(all, [](const SurfacePoint& p) { return p.position; }));
  samples->SetVerts(vertexForEach(count(all)));
  vtkPointData* data = samples->GetPointData();
  data->SetNormals(
    tuples<vtkFloatArray>(names::Normals, 3, all, [](const SurfacePoint& p) { return p.normal; }));
  add<vtkDoubleArray>(data, names::Spacing, made.samples.spacings);
  data->SetActiveScalars(names::Spacing);
  add<vtkIdTypeArray>(data, names::SourceCell, all,
    [&surface](const SurfacePoint& p) { return surface.polygons[p.triangle]; });
  passInput(input, samples->GetFieldData());
  addField(made, surface, samples->GetFieldData());

  closed->SetPoints(points(surface.points));
  closed->SetPolys(cellArray(surface.triangles));
  add<vtkIdTypeArray>(closed->GetCellData(), names::SourceCell, surface.polygons);
  passInput(input, closed->GetFieldData());
  addField(made, surface, closed->GetFieldData());
}
}
