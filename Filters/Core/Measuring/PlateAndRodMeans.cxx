// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/PlateAndRodMeans.h"

#include "Base/BallTree.h"
#include "Measuring/PlatesAndRods.h"
#include "Measuring/PointVolumes.h"

namespace medial
{
namespace
{
/// A mean of values with weights.
class WeightedMean
{
public:
  void add(double value, double weight)
  {
    this->sum += value * weight;
    this->weights += weight;
  }
  double weight() const { return this->weights; }
  double value() const
  {
    return this->weights > 0 ? this->sum / this->weights : std::numeric_limits<double>::quiet_NaN();
  }

private:
  double sum = 0, weights = 0;
};
}

PlateAndRodMeans plateAndRodMeans(const MedialAxis& axis, const std::vector<double>& distances,
  const Eigen::AlignedBox3d& box, const Execution& execution)
{
  const PlatesAndRods found = platesAndRods(axis, {}, execution);
  const std::vector<double> volumes = pointVolumes(axis);
  const double widest = boundingDiagonal(maximalBalls(axis)); // nothing is wider
  PlateAndRodMeans result;
  WeightedMean thickness[2], width; // of rods, of plates
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    const Index element = found.elementOfPoint[i];
    if (element == None || !box.contains(axis.points[i]))
    {
      continue;
    }
    const bool isPlate = found.elements[element].isPlate;
    const Index ball = axis.ballOfPoint[i];
    thickness[isPlate].add(2 * (ball == None ? axis.radii[i] : distances[ball]), volumes[i]);
    if (isPlate && found.widths.width[i] <= widest)
    {
      width.add(found.widths.width[i], volumes[i]);
    }
  }
  WeightedMean area, length;
  for (const Element& element : found.elements)
  {
    if (box.contains(element.centroid))
    {
      (element.isPlate ? result.plates : result.rods) += 1;
      element.isPlate ? area.add(element.area, 1) : length.add(element.length, 1);
    }
  }
  result.plateArea = area.value();
  result.rodLength = length.value();
  result.plateJunctions = found.plateJunctions;
  result.mixedJunctions = found.mixedJunctions;
  result.rodJunctions = found.rodJunctions;
  const double all = thickness[0].weight() + thickness[1].weight();
  if (all > 0)
  {
    result.rodShare = thickness[0].weight() / all;
    result.plateShare = thickness[1].weight() / all;
  }
  result.rodThickness = thickness[0].value();
  result.plateThickness = thickness[1].value();
  result.plateWidth = width.value();
  return result;
}
}
