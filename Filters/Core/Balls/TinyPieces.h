// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_TinyPieces_h
#define medial_TinyPieces_h

#include "Balls/SampleEvidence.h"
#include "Base/Warnings.h"

namespace medial
{
/// Warns ("tiny_pieces") where a piece of the solid, or a void in it, has fewer samples than a dozen. Stray
/// samples make such pieces: any four of them may have an inner ball.
Warnings tinyPieces(const SampleEvidence& evidence);
}

#endif
