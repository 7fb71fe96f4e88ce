// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/PlateAndRodMeans.h"

#include "Base/BallTree.h"
#include "Measuring/PlatesAndRods.h"
#include "Measuring/PointVolumes.h"

#include <algorithm>
#include <vector>

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
  double value() const
  {
    return this->weights > 0 ? this->sum / this->weights : std::numeric_limits<double>::quiet_NaN();
  }

private:
  double sum = 0, weights = 0;
};

/// How much of a plate each point is, 0 ... 1. In networks of short plates and rods most of the volume is about 1.5 times as
/// wide as thick, and short rods between plates are necks of these. So a step there, or whole elements, would make the
/// share of plates depend on the sampling. Rods that meet no plate are none.
std::vector<double> plateShares(const PlatesAndRods& found)
{
  constexpr double none = 1.25, all = 1.75; // width / thickness
  std::vector<char> meetsPlate;
  for (Index e = 0; e < count(found.elements); ++e)
  {
    const IndexLists::View others = found.neighbors[e];
    meetsPlate.push_back(found.elements[e].isPlate ||
      std::any_of(
        others.begin(), others.end(), [&](Index other) { return found.elements[other].isPlate; }));
  }
  std::vector<double> result;
  for (Index p = 0; p < count(found.elementOfPoint); ++p)
  {
    const Index element = found.elementOfPoint[p];
    const double share = std::clamp((found.widths.ratio[p] - none) / (all - none), 0.0, 1.0);
    result.push_back(element != None && meetsPlate[element] ? share : 0);
  }
  return result;
}
}

PlateAndRodMeans plateAndRodMeans(const MedialAxis& axis, const std::vector<double>& distances,
  const Eigen::AlignedBox3d& box, const Execution& execution)
{
  const PlatesAndRods found = platesAndRods(axis, {}, execution);
  const std::vector<double> volumes = pointVolumes(axis);
  const double widest = boundingDiagonal(maximalBalls(axis)); // nothing is wider
  const std::vector<double> shares = plateShares(found);
  PlateAndRodMeans result;
  WeightedMean thickness[2], width, share; // of rods, of plates
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    const Index element = found.elementOfPoint[i];
    if (element == None || !box.contains(axis.points[i]))
    {
      continue;
    }
    const bool isPlate = found.elements[element].isPlate;
    share.add(shares[i], volumes[i]);
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
  result.plateShare = share.value();
  result.rodShare = 1 - share.value();
  result.rodThickness = thickness[0].value();
  result.plateThickness = thickness[1].value();
  result.plateWidth = width.value();
  return result;
}
}
