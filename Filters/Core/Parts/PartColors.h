// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PartColors_h
#define medial_PartColors_h

#include <array>
#include <cstdint>

namespace medial
{
/// Red, green and blue (sRGB, 0 ... 1) of a part, always the same for the same number. Neighbouring
/// numbers get very different colours: that numbers are neighbours means nothing.
/// @param part  its number; what is negative belongs to no part and is light grey
std::array<double, 3> partColor(std::int64_t part);
}

#endif
