// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Poles_h
#define medial_Poles_h

#include "Balls/DelaunaySpheres.h"
#include "Base/Types.h"

#include <array>
#include <vector>

namespace medial
{
/// The poles of each sample, as classes: their lowest cells.
struct Poles
{
  /// The first pole is the farthest Voronoi vertex of the sample's cell, the second one the farthest
  /// in the opposite half-space. Of several equally far ones the lowest class; None where there is none.
  std::vector<std::array<Index, 2>> ofSample;
  std::vector<char>
    isPole; ///< for each cell: is it the lowest of a class that is as far as a pole?
};

/// The poles of samples. On a sharp convex edge both are outside, in front of two faces. Takes time linear
/// in the cells.
Poles poles(const DelaunaySpheres& spheres);
}

#endif
