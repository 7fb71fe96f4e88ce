// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SliverLimits_h
#define medial_SliverLimits_h

#include <algorithm>

namespace medial
{
/// How small parts of a crust in a frame may be. What is smaller is far below the distance of samples,
/// so nobody misses it, and tools that get the surface stumble over it.
struct SliverLimits
{
  /// @param spacing  of the samples. Where it is below 1e-3 of the object, all limits shrink with it.
  explicit SliverLimits(double spacing)
    : side(std::min(0x1p-18, spacing / 256))
    , distance(side / 16)
    , area(0.275 * side * side)
  {
  }

  /// Sides of flat triangles below this length, 4e-6 of the object, are contracted.
  double side;

  /// Points nearer than this, 2e-7 of the object, are one or moved apart. Single precision tells apart
  /// what is farther: such points differ by 1.4e-7 in a coordinate at least. Coordinates in a frame,
  /// or about any origin that is not far outside the object, are at most 2, where single precision
  /// has steps of 1.2e-7.
  double distance;

  /// Triangles are flat below this area, 4e-12. The object's diagonal is at most 1.74 in a frame, so this
  /// is more than 1e-12 of its square; a triangle with all three sides of length `side` has more.
  double area;
};
}

#endif
