// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Elements_h
#define medial_Elements_h

#include "Axis/MedialAxis.h"
#include "Base/Lists.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// A single plate or rod. Lengths are in the unit of the samples.
struct Element
{
  bool isPlate = false;
  double volume = 0; ///< of the balls at its points, and those that follow them
  double area = 0;   ///< of a plate's axis, without fins; 0 for a rod
  double length = 0; ///< of a rod's curve, between the centres of its last balls; 0 for a plate

  // The diameter of the maximal balls at its points; the mean by the volumes of the points, as of uniform
  // points of the volume, or of all points alike where these are 0.
  double meanThickness = 0, leastThickness = 0, largestThickness = 0;

  Point centroid = Point::Zero(); ///< of its cells, by area or length

  /// A plate's normal, a rod's axis; in the sense in which the component with the largest amount is
  /// positive.
  Point direction = Point::UnitX();
};

/// Measures the elements, all but `isPlate` and `length`, which are kept.
/// @param elementsOfPoint  for each point the elements that share its volume alike; none: it has no element
/// @param elementOfCell    number of an element, or None
/// @param isFin                          for each triangle: is its area left out?
void measure(const MedialAxis& axis, const IndexLists& elementsOfPoint,
  const std::vector<Index>& elementOfCell, const std::vector<char>& isFin,
  std::vector<Element>& elements);
}

#endif
