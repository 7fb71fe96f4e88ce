// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_RodPieces_h
#define medial_RodPieces_h

#include "Measuring/Centerline.h"

#include <array>
#include <vector>

namespace medial
{
/// Stands for the node of a curve's end where a plate begins.
constexpr Index AtPlate = -2;

/// The pieces of a curve that are in rods, in order: where the sheet is at most `widthRatio` times as wide
/// as thick.
///
/// The sheet has to be wider, or narrower, over a length of its thickness to count: a fork is no plate.
/// Since a sheet is narrow at its rim, a piece between a free end and a plate is left out if it reaches
/// less than a radius beyond the rim of the plate.
/// @param isFree  are its ends free?
std::vector<Centerline> rodPieces(
  const Centerline& curve, const std::array<bool, 2>& isFree, double widthRatio);
}

#endif
