// SPDX-License-Identifier: BSD-3-Clause
#ifndef RunStage_h
#define RunStage_h

#include "Base/Execution.h"

class vtkAlgorithm;

namespace medial
{
/// Updates a filter that works inside another one. Its progress goes to `execution`.
/// @throw Aborted       execution wants to stop
/// @throw InvalidInput  the filter's first error; nothing is printed
void runStage(vtkAlgorithm* stage, const Execution& execution);
}

#endif
