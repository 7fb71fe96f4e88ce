// SPDX-License-Identifier: BSD-3-Clause
#include "Imaging/ImageBoundary.h"

#include "Base/Errors.h"
#include "Base/SolidMeasures.h"
#include "Images/ImageWarnings.h"
#include "Images/MaskBetti.h"
#include "Images/MaskDifference.h"

#include <utility>

namespace medial
{
Index marginOf(const BoundaryOptions& options)
{
  return options.pad ? 1 + reach(options.smoothing) : 0;
}

ImageBoundary imageBoundary(
  vtkAlgorithm* filter, VoxelMask mask, const BoundaryOptions& options, const Execution& execution)
{
  ImageBoundary result{};
  result.repairs = repairMask(mask, options.repair, execution.between(0, 0.2));
  result.cut = borderVoxels(mask);
  result.margin = marginOf(options);
  std::optional<Point> cutAt = firstBorderVoxel(mask);
  if (cutAt)
  {
    *cutAt += Point::Constant(result.margin);
  }
  result.mask = options.pad ? padded(mask, result.margin) : std::move(mask);
  result.segmentation = maskBetti(result.mask, execution.between(0.2, 0.4));
  result.surface = maskSurface(
    filter, result.mask, options.smoothing, options.repair, execution.between(0.4, 0.9));
  if (result.surface.triangles.empty())
  {
    throw InvalidInput(
      "the solid is thinner than its smoothing: smooth less, or take a finer image");
  }
  const SolidMeasures measures =
    solidMeasures(result.surface.points, result.surface.triangles, execution.between(0.9, 1));
  if (measures.closed && measures.manifold)
  {
    result.betti = measures.betti;
    std::optional<Point> differsAt;
    if (result.betti != result.segmentation)
    {
      differsAt = topologyDifference(result.mask, result.surface.mask, execution);
      differsAt = differsAt ? differsAt : bareContact(result.mask, execution);
    }
    result.warnings = imageWarnings(result.segmentation, result.betti,
      options.pad ? result.cut : std::array<Index, 6>{}, cutAt, differsAt);
  }
  return result;
}
}
