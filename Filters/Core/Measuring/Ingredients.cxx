// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/Ingredients.h"

#include "Base/Frame.h"
#include "Base/SolidMeasures.h"
#include "Measuring/Anisotropy.h"
#include "Measuring/PlateAndRodMeans.h"
#include "Measuring/SampleWalls.h"

#include <algorithm>

namespace medial
{
namespace
{
using Box = Eigen::AlignedBox3d;

/// Does the box hold all of the surface?
bool holds(const Box& box, const std::vector<Point>& points)
{
  return std::all_of(
    points.begin(), points.end(), [&box](const Point& point) { return box.contains(point); });
}

/// Fills what a surface tells that bounds a solid.
void measureSolid(const MeasuredSolid& solid, const Box& box, MorphometryIngredients& result,
  const Execution& execution)
{
  const SolidMeasures measures = solidMeasures(solid.points, solid.triangles, execution);
  if (measures.closed)
  {
    result.solidVolume =
      volumeWithin(box, solid.points, solid.triangles, execution.between(0.2, 0.4));
  }
  if (measures.manifold)
  {
    result.isShell = measures.betti == Betti{ 1, 0, 1 };
    result.euler = measures.betti[0] - measures.betti[1] + measures.betti[2];
    result.eulerWithin = result.isWhole
      ? result.euler
      : eulerWithin(box, solid.points, solid.triangles, execution.between(0.4, 0.5));
  }
}

void measureThickness(const PolarBalls& balls, const std::vector<double>& distances,
  const std::optional<Box>& bounds, double margin, MorphometryIngredients& result,
  const Execution& execution)
{
  ThicknessBounds volume;
  if (bounds || margin > 0)
  {
    volume.bounds = bounds ? *bounds : boundingBox(balls.samples);
    volume.margin = margin > 0 ? margin : volume.margin;
  }
  constexpr Index points = 10000;
  result.volume = volumeThickness(balls, distances, volume, points, execution);
}

void measureElements(const MedialAxis& axis, const std::vector<double>& distances, const Box& box,
  MorphometryIngredients& result, const Execution& execution)
{
  const PlateAndRodMeans means = plateAndRodMeans(axis, distances, box, execution);
  result.plateShare = means.plateShare;
  result.rodShare = means.rodShare;
  result.plates = means.plates;
  result.rods = means.rods;
  result.plateThickness = means.plateThickness;
  result.rodThickness = means.rodThickness;
  result.plateWidth = means.plateWidth;
  result.plateArea = means.plateArea;
  result.rodLength = means.rodLength;
  if (result.isWhole) // junctions have no place
  {
    result.plateJunctions = means.plateJunctions;
    result.mixedJunctions = means.mixedJunctions;
    result.rodJunctions = means.rodJunctions;
  }
}
}

MorphometryIngredients ingredients(const MeasuredSolid& solid, const std::optional<Box>& bounds,
  double margin, const Execution& execution)
{
  const Box volume = volumeOfInterest(solid.balls.samples, bounds, margin);
  const bool takesAll = !bounds && margin == 0;
  const Box box = takesAll ? volume.merged(boundingBox(solid.points)) : volume;
  const Box axisBox = takesAll ? volume.merged(boundingBox(solid.axis.points)) : volume;
  MorphometryIngredients result;
  result.spacing = solid.balls.spacing;
  result.totalVolume = volume.volume();
  result.isWhole = holds(box, solid.points);
  result.axisArea = areaOf(
    areasWithin(axisBox, solid.axis.points, solid.axis.cells.triangles, execution.between(0, 0.2)));
  measureSolid(solid, box, result, execution);
  const std::vector<Point> areas =
    areasWithin(box, solid.points, solid.triangles, execution.between(0.5, 0.6));
  result.surfaceArea = areaOf(areas);
  result.anisotropy = degreeOfAnisotropy(areas, execution.between(0.6, 0.7));
  if (!solid.balls.balls.empty())
  {
    const std::vector<double> distances =
      wallDistances(solid.balls, sampleWalls(solid.balls, execution.between(0.7, 0.75)));
    measureThickness(solid.balls, distances, bounds, margin, result, execution.between(0.75, 0.9));
    measureElements(solid.axis, distances, axisBox, result, execution.between(0.9, 1));
  }
  return result;
}
}
