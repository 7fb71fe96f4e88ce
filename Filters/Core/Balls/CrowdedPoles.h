// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CrowdedPoles_h
#define medial_CrowdedPoles_h

#include "Balls/DelaunaySpheres.h"
#include "Balls/Poles.h"

#include <vector>

namespace medial
{
/// How far a sample may be from the ball that stands for its pole's, in the distance to the nearest other sample.
constexpr double crowdPrecision = 0.01;

/// In a tube each sample has a pole of its own near the tube's axis, so that very many follow each other within a
/// spacing. Their power cells are thin discs, each of which meets a whole ring of outer cells: time and memory would
/// grow with n^1.5 for n samples. So one of them stands for the others.
///
/// A pole stands for 15 others at least. The centres of these are nearer than half the distance between their
/// samples, and the samples on its sphere up to crowdPrecision. No poles of most other shapes are in a crowd. Takes
/// O(n log n) time for n cells.
/// @return  for each pole, by its class, the one that stands for it or itself; None for classes that are no poles
std::vector<Index> standingPoles(const DelaunaySpheres& spheres, const Poles& poles);

/// The same where no poles crowd: each stands for itself.
std::vector<Index> polesAlone(const Poles& poles);
}

#endif
