// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Warnings_h
#define Conversion_Warnings_h

#include "Base/Warnings.h"

class vtkFieldData;

namespace medial
{
/// The warnings in the field data of an input, in their order; none without such arrays.
/// @throw InvalidInput  an array is missing or does not fit
Warnings readWarnings(vtkFieldData* field);

/// Adds warnings to those that an output has got from an input. What is there already, word by word,
/// isn't added again.
/// @throw InvalidInput  what is there does not fit
void addWarnings(vtkFieldData* field, const Warnings& warnings);
}

#endif
