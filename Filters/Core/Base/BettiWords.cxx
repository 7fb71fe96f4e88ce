// SPDX-License-Identifier: BSD-3-Clause
#include "Base/BettiWords.h"

#include "Base/Errors.h"

namespace medial
{
namespace
{
std::string counted(Index number, const char* thing)
{
  return text(number, " ", thing, number == 1 ? "" : "s");
}
}

std::string inWords(const Betti& betti)
{
  return counted(betti[0], "piece") + ", " + counted(betti[1], "tunnel") + ", " +
    counted(betti[2], "void");
}
}
