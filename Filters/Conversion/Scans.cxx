// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Scans.h"

#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Balls.h"
#include "Conversion/Cells.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <vector>

namespace medial
{
namespace
{
std::vector<Point> normalsOf(const CleanScan& made, vtkPointSet* input)
{
  const std::vector<Point> given = readNormals(input);
  if (!made.normals.empty() || given.empty())
  {
    return made.normals;
  }
  std::vector<Point> result;
  for (const Index id : made.ids)
  {
    result.push_back(given[id]);
  }
  return result;
}
}

void write(const CleanScan& made, vtkPointSet* input, vtkPolyData* output)
{
  output->SetPoints(points(made.samples));
  output->SetVerts(vertexForEach(count(made.samples)));
  add<vtkIdTypeArray>(output->GetPointData(), names::InputPoint, made.ids);
  const std::vector<Point> normals = normalsOf(made, input);
  if (!normals.empty())
  {
    output->GetPointData()->SetNormals(tuples<vtkDoubleArray>(names::Normals, 3, normals));
  }
  vtkFieldData* field = output->GetFieldData();
  passInput(input, field);
  field->RemoveArray(names::SampleResolution); // samples that were moved are doubles
  addOne<vtkDoubleArray>(field, names::NoiseBefore, made.noiseBefore);
  addOne<vtkDoubleArray>(field, names::NoiseAfter, made.noiseAfter);
  addOne<vtkIdTypeArray>(field, names::DroppedOutliers, made.outliers);
  addOne<vtkIdTypeArray>(field, names::ThinnedSamples, made.thinned);
  addOne<vtkIdTypeArray>(field, names::SmoothingRounds, made.smoothingRounds);
  addOne<vtkDoubleArray>(field, names::Thinning, made.thinning);
}
}
