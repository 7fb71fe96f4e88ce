// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ThicknessReport_h
#define medial_ThicknessReport_h

#include "Axis/AxisComplex.h"
#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Types.h"
#include "Measuring/Distribution.h"
#include "Measuring/ThinPlaces.h"
#include "Measuring/VolumeThickness.h"

#include <vector>

namespace medial
{
struct ThicknessOptions
{
  double tolerance =
    0.25; ///< how far outside of a ball a place may be, in sample spacings; 0 or more
  bool separation = true; ///< is it measured, too? Searches outside take longer
  ThicknessBounds volume; ///< for the means over the volume
  Index points = 10000;   ///< for these means, see volumeThickness(); 0: none are made
  double depth = 0.1;     ///< of thin places, see thinPlaces()
};

/// Thickness or separation at some places.
struct PlaceThickness
{
  std::vector<Index> balls;      ///< the largest one that contains the place, or None
  std::vector<double> diameters; ///< twice its wall distance; not a number without a ball
};

struct ThicknessReport
{
  PlaceThickness inside, outside; ///< at the places; outside is empty where it isn't measured
  VolumeThickness volume;
  Distribution ofBalls; ///< of the inner balls, each once
  std::vector<ThinPlace> thin;
};

/// Measures thickness by the polar balls of a solid [HR97].
/// @param places  where; none: at the samples
/// @param axis    of these balls, for thin places; none: they are not looked for
/// @throw InvalidInput  an option is out of range
/// @throw Aborted
ThicknessReport thicknessReport(const PolarBalls& balls, const std::vector<Point>* places,
  const AxisComplex* axis, const ThicknessOptions& options = {}, const Execution& execution = {});
}

#endif
