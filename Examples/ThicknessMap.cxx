// SPDX-License-Identifier: BSD-3-Clause
#include "ThicknessMap.h"

#include "Errors.h"
#include "Messages.h"
#include "Progress.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkLocalThickness.h>
#include <vtkMedialPrune.h>
#include <vtkPointData.h>
#include <vtkPowerCrust.h>
#include <vtkSimplifyShape.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

namespace
{
double largestThickness(vtkPolyData* data)
{
  double range[2];
  data->GetPointData()->GetArray("Thickness")->GetFiniteRange(range, 0);
  return range[1];
}

vtkSmartPointer<vtkLocalThickness> measuring(vtkDataObject* balls, vtkDataObject* places)
{
  auto result = vtkSmartPointer<vtkLocalThickness>::New();
  result->SetInputDataObject(0, balls);
  result->SetPlacesData(places);
  result->MeasureSeparationOff();
  return result;
}

vtkPolyData* measured(vtkLocalThickness* thickness)
{
  thickness->Update();
  if (thickness->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InputError("the thickness can't be measured: " + messages::error());
  }
  return vtkPolyData::SafeDownCast(thickness->GetOutput());
}

vtkTable* table(vtkAlgorithm* filter, int port)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
}

/// The cells of an axis with the thickness at its points, without anything else.
vtkSmartPointer<vtkPolyData> thicknessAlone(vtkPolyData* axis)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->CopyStructure(axis);
  result->GetPointData()->AddArray(axis->GetPointData()->GetArray("Thickness"));
  return result;
}
}

double ThicknessMap::top() const
{
  const double largest = std::max({ largestThickness(this->surface), largestThickness(this->axis),
    volumeMean(this->means, "Thickness").largest });
  return std::isfinite(largest) && largest > 0 ? largest : 1;
}

VolumeMean volumeMean(vtkTable* means, const char* quantity)
{
  for (vtkIdType row = 0; row < means->GetNumberOfRows(); ++row)
  {
    if (means->GetValueByName(row, "Quantity").ToString() == quantity &&
      means->GetValueByName(row, "Weight").ToString() == "volume")
    {
      const auto value = [&](const char* column) {
        return means->GetValueByName(row, column).ToDouble();
      };
      auto* bins = vtkDataArray::SafeDownCast(means->GetColumnByName("Histogram"));
      std::vector<double> histogram(bins->GetNumberOfComponents());
      bins->GetTuple(row, histogram.data());
      return { value("Mean"), value("Deviation"), value("Minimum"), value("Maximum"),
        value("Number"), histogram };
    }
  }
  throw InputError(std::string("the table of means has no ") + quantity);
}

ThicknessMap thicknessMap(vtkSimplifyShape* simplify, vtkTable* means, Progress& progress)
{
  vtkPolyData* pruned = simplify->GetMedialPrune()->GetOutput();
  const auto atSurface = measuring(simplify->GetBalls(), simplify->GetOutput());
  atSurface->SetAxisData(pruned);
  if (means)
  {
    atSurface->SetNumberOfPoints(0);
  }
  progress.watch("thickness", atSurface);
  const auto atAxis = measuring(simplify->GetBalls(), pruned);
  atAxis->SetNumberOfPoints(0);
  progress.watch("thickness of axis", atAxis);
  return { measured(atSurface), thicknessAlone(measured(atAxis)),
    means ? means : table(atSurface, 1), table(atSurface, 2) };
}
