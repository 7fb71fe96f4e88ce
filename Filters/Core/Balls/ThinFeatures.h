// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ThinFeatures_h
#define medial_ThinFeatures_h

#include "Balls/SampleEvidence.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

namespace medial
{
/// Warns where balls about as small as the spacing decide the topology: without the small inner ones
/// ("thin_parts"), or with the small outer ones ("narrow_gaps"), the power shape has other Betti numbers.
/// Samples of a part so thin can't tell it from two parts, nor a gap so narrow from none.
/// @param betti  of the power shape
Warnings thinFeatures(const SampleEvidence& evidence, const Betti& betti);
}

#endif
