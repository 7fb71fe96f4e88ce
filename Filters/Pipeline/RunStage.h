// SPDX-License-Identifier: BSD-3-Clause
#ifndef RunStage_h
#define RunStage_h

#include "Base/Execution.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkAlgorithm;

namespace medial
{
/// A filter that works inside another one.
struct Stage
{
  vtkAlgorithm* filter;
  double share; ///< of the progress that the stages report together; the shares add up to 1
  bool tellsWarnings =
    true; ///< false: only compared with, so its warnings say nothing of the result
};

/// Updates the stages in order. Their progress goes to `execution`, their warnings become warnings of
/// `filter`; nothing else is printed.
/// @param filter        the one that the stages work in
/// @throw Aborted       execution wants to stop
/// @throw InvalidInput  the error message of the first stage that fails
void runStages(vtkAlgorithm* filter, const std::vector<Stage>& stages, const Execution& execution);

/// A copy, which has no pipeline behind it.
template <typename Data>
vtkSmartPointer<Data> copyOf(Data* input)
{
  const auto result = vtkSmartPointer<Data>::Take(input->NewInstance());
  result->ShallowCopy(input);
  return result;
}

/// Takes points, cells and their arrays out of the outputs of stages. An update of these makes them again.
void releaseOutputs(const std::vector<vtkAlgorithm*>& stages);
}

#endif
