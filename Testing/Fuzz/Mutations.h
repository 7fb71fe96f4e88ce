// SPDX-License-Identifier: BSD-3-Clause
#ifndef Mutations_h
#define Mutations_h

#include "Random.h"

#include <string>

class vtkPointSet;

namespace fuzz
{
/// Changes one thing of an output of a stage: values, length, components or type of an array, points, or
/// cells. What it gives may be valid by chance.
/// @param data   a deep copy; becomes what no filter would write, from a file or from memory
/// @param other  the same kind of data of another object, to take arrays from
/// @return       what was changed, in words
std::string mutate(vtkPointSet* data, vtkPointSet* other, Random& random);
}

#endif
