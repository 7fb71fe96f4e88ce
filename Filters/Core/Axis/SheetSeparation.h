// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SheetSeparation_h
#define medial_SheetSeparation_h

#include "Axis/FaceComplex.h"
#include "Axis/Sheets.h"

namespace medial
{
/// Collapses faces so that two sheets which meet a third one at a seam are not one sheet around its end.
///
/// Where the third sheet ends a little earlier than the others, as at a sharp corner of the solid, faces
/// lead from one of the others to the other around its end. The shallowest of these faces with a free
/// side goes; where none of them has a free side, one of the faces next to them, as long as these are
/// within the maximal ball at the end of the seam.
void separateSheets(FaceComplex& faces, const FaceGeometry& geometry);
}

#endif
