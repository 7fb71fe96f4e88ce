// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellMutations_h
#define CellMutations_h

#include "Random.h"

#include <string>

class vtkPointSet;

namespace fuzz
{
/// Changes one thing of the cells of a grid or a surface: their corners, their offsets, their types, or
/// which cells there are, with or without their arrays.
/// @return  what was changed, in words
std::string mutateCells(vtkPointSet* data, Random& random);
}

#endif
