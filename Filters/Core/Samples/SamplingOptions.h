// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SamplingOptions_h
#define medial_SamplingOptions_h

#include "Base/Types.h"
#include "Samples/ClosedSurface.h"

namespace medial
{
struct SamplingOptions
{
  /// How far samples are apart at most, as a fraction of the thickness of the solid and of the gaps there.
  double fineness = 0.25;

  /// Nowhere farther apart; 0: so that a surface without thin places gets as many samples as it has
  /// points, but at least 20,000 and at most 50,000.
  double spacing = 0;

  bool adaptive = true; ///< false: the same spacing everywhere

  Index maximumSamples = 1000000;

  double sharpAngle = 30; ///< between the normals at an edge where samples come in pairs; degrees
};

/// @throw InvalidInput  an option is out of range
void check(const SamplingOptions& options);

/// The spacing of samples that show what the surface's points show, and enough of a surface with few.
double usualSpacing(const ClosedSurface& surface);

/// The spacing that makes as many samples as are allowed, if it is the same everywhere.
double closestSpacing(const ClosedSurface& surface, const SamplingOptions& options);

/// @throw InvalidInput  the surface is so narrow that only its length asks for more samples than anybody can
///                      pay, as where a corner lies at a wrong place far away
void checkLength(const ClosedSurface& surface);
}

#endif
