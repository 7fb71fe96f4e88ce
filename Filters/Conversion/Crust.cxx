// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Crust.h"

#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Balls.h"
#include "Conversion/Cells.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace medial
{
void write(const Crust& crust, const std::vector<Index>& partOfBall,
  const std::vector<Index>& ranks, vtkUnstructuredGrid* balls, vtkPolyData* output)
{
  const auto part = [&](Index ball) { return partOfBall.empty() ? None : partOfBall[ball]; };

  output->SetPoints(points(crust.points));
  output->SetPolys(cellArray(crust.triangles));
  add<vtkIdTypeArray>(output->GetPointData(), names::SampleId, crust.sampleOfPoint);
  vtkCellData* cells = output->GetCellData();
  add<vtkIdTypeArray>(cells, names::InnerBall, crust.innerBall);
  add<vtkIdTypeArray>(cells, names::OuterBall, crust.outerBall);
  add<vtkIdTypeArray>(cells, names::PartId, crust.innerBall, part);
  add<vtkIdTypeArray>(cells, names::PartRank, crust.innerBall,
    [&](Index ball) { return part(ball) == None ? None : ranks[part(ball)]; });
  if (!partOfBall.empty())
  {
    cells->SetActiveScalars(names::PartRank);
  }
  vtkFieldData* field = output->GetFieldData();
  passFieldData(balls, field);
  addBetti(field, names::BettiCrust, crust.betti);
  addOne<vtkUnsignedCharArray>(field, names::Closed, crust.closed);
  addOne<vtkUnsignedCharArray>(field, names::Manifold, crust.manifold);
  addOne<vtkDoubleArray>(field, names::Volume, crust.volume);
  addOne<vtkIdTypeArray>(field, names::PutBackBalls, crust.putBackBalls);
  addOne<vtkIdTypeArray>(field, names::InsertedBalls, crust.insertedBalls);
  addOne<vtkIdTypeArray>(field, names::RefusedBalls, crust.refusedBalls);
  addOne<vtkIdTypeArray>(field, names::Rounds, crust.rounds);
  addOne<vtkDoubleArray>(field, names::MaximumClearance, crust.maximumClearance);
  addOne<vtkDoubleArray>(field, names::MovedBy, crust.moved.percentile99);
  addOne<vtkDoubleArray>(field, names::MovedAtMost, crust.moved.largest);
}
}
