// SPDX-License-Identifier: BSD-3-Clause
#include "Imaging/MaskSurface.h"

#include "Pipeline/RunStage.h"
#include "Samples/KeptThickness.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWindowedSincPolyDataFilter.h"

#include <cmath>
#include <utility>

// VTK 9.1's filters don't all heed an image's direction, so everything is done in voxels.

namespace medial
{
namespace
{
constexpr double RadiusFactor = 3; // the Gaussian is below a hundredth of its peak there

vtkSmartPointer<vtkImageData> imageOf(const VoxelMask& mask)
{
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(static_cast<vtkIdType>(mask.inside.size()));
  for (std::size_t i = 0; i < mask.inside.size(); ++i)
  {
    values->SetValue(static_cast<vtkIdType>(i), mask.inside[i]);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(mask.size[0], mask.size[1], mask.size[2]);
  image->GetPointData()->SetScalars(values);
  return image;
}

void smoothMask(
  vtkAlgorithm* filter, vtkImageData* image, double radius, const Execution& execution)
{
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(image);
  smooth->SetStandardDeviation(radius);
  smooth->SetRadiusFactor(RadiusFactor);
  runStages(filter, { { smooth, 1 } }, execution);
  image->ShallowCopy(smooth->GetOutput());
}

/// Moves values away from 1/2, the surface's, so that no point of it comes near a voxel's centre. A wall that is barely
/// thicker than what the Gaussian takes away has only these centres inside: else it would be as thin as one likes,
/// and there would be no telling its sides apart. Now it is at least about half a voxel thick, and so are gaps. Other
/// surfaces are as near to the solid as before; measured.
void avoidCentres(vtkImageData* image)
{
  constexpr float half = 0.5F, margin = 0.15F;
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    const float value = values->GetValue(i);
    if (std::abs(value - half) < margin)
    {
      values->SetValue(i, value < half ? half - margin : half + margin);
    }
  }
}

/// Smoothing breaks thin walls and opens thin gaps, and a contour separates voxels that share only an edge
/// or a corner: fills the cavities and drops the pieces that come from this, too. Their values change
/// sides of 1/2.
/// @return  the mask that the values are of then
VoxelMask repairValues(
  vtkImageData* image, VoxelMask mask, const MaskOptions& options, const Execution& execution)
{
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  const auto isInside = [values](std::size_t i) {
    return values->GetValue(static_cast<vtkIdType>(i)) > 0.5F;
  };
  for (std::size_t i = 0; i < mask.inside.size(); ++i)
  {
    mask.inside[i] = isInside(i) ? 1 : 0;
  }
  repairMask(mask, options, execution, VoxelContact::Contour);
  for (std::size_t i = 0; i < mask.inside.size(); ++i)
  {
    if ((mask.inside[i] != 0) != isInside(i))
    {
      const auto voxel = static_cast<vtkIdType>(i);
      values->SetValue(voxel, 1 - values->GetValue(voxel));
    }
  }
  return mask;
}

std::vector<Point> pointsOf(vtkPolyData* surface)
{
  std::vector<Point> result;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    result.emplace_back(surface->GetPoint(i));
  }
  return result;
}

MaskSurface read(vtkPolyData* surface)
{
  MaskSurface result;
  result.points = pointsOf(surface);
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(size, corners);
    result.triangles.push_back({ static_cast<Index>(corners[0]), static_cast<Index>(corners[1]),
      static_cast<Index>(corners[2]) });
  }
  return result;
}
}

Index reach(const SurfaceSmoothing& smoothing)
{
  return static_cast<Index>(RadiusFactor * smoothing.gaussianRadius);
}

MaskSurface maskSurface(vtkAlgorithm* filter, const VoxelMask& mask,
  const SurfaceSmoothing& smoothing, const MaskOptions& repair, const Execution& execution)
{
  const vtkSmartPointer<vtkImageData> image = imageOf(mask);
  if (smoothing.gaussianRadius > 0)
  {
    smoothMask(filter, image, smoothing.gaussianRadius, execution.between(0, 0.4));
    avoidCentres(image);
  }
  VoxelMask enclosed = repairValues(image, mask, repair, execution.between(0.4, 0.6));
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.5);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(contour->GetOutputPort());
  smooth->SetNumberOfIterations(smoothing.iterations);
  smooth->SetPassBand(smoothing.passBand);
  smooth->NormalizeCoordinatesOn();
  smooth->FeatureEdgeSmoothingOff();
  smooth->BoundarySmoothingOff();
  if (smoothing.iterations > 0)
  {
    runStages(filter, { { contour, 0.5 }, { smooth, 0.5 } }, execution.between(0.6, 0.8));
  }
  else
  {
    runStages(filter, { { contour, 1 } }, execution.between(0.6, 0.8));
  }
  execution.poll();
  MaskSurface result = read(contour->GetOutput());
  if (smoothing.iterations > 0)
  {
    constexpr double thick = 4; // voxels: smoothing moves nothing by a voxel
    result.points = withThicknessKept(result.points, pointsOf(smooth->GetOutput()),
      result.triangles, thick, execution.between(0.8, 1));
  }
  result.mask = std::move(enclosed);
  return result;
}
}
