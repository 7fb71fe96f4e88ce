// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_BettiWords_h
#define medial_BettiWords_h

#include "Base/Types.h"

#include <string>

namespace medial
{
/// Betti numbers for people: "1 piece, 2 tunnels, 0 voids".
std::string inWords(const Betti& betti);
}

#endif
