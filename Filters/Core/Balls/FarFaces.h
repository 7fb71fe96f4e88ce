// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_FarFaces_h
#define medial_FarFaces_h

#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/SurfaceTree.h"
#include "Samples/LocalThickness.h"

#include <functional>
#include <vector>

namespace medial
{
/// A face of the power crust that is far from the surface of the solid.
struct FarFace
{
  Point place;     ///< on the face
  double distance; ///< of the place from the surface, in spacings
  double spacing;  ///< there: the mean distance of the nearest sample from its six nearest
};

/// Places that don't count. A test that is missing leaves out none.
struct PlacesLeftOut
{
  std::function<bool(const Point& place, double spacing)>
    near;                                            ///< tells by the spacing there; asked last
  std::function<bool(const Point& place)> elsewhere; ///< asked before anything that takes time
};

/// The faces between inner and outer power cells that are farther than `most` from the surface of the solid:
/// the samples around are placed so badly that a face spans from one wall to another one. Each with its
/// farthest place, in the order of their balls.
/// @param balls      of the samples
/// @param samples    of the surface in the tree
/// @param most       in spacings
std::vector<FarFace> farFaces(const PolarBalls& balls, const std::vector<SurfacePoint>& samples,
  const SurfaceTree& solid, double most, const PlacesLeftOut& leftOut = {},
  const Execution& execution = {});
}

#endif
