// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReportWarnings_h
#define ReportWarnings_h

#include "Base/Warnings.h"
#include "Conversion/Warnings.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkSetGet.h"

#include <initializer_list>

namespace medial
{
/// Tells what a filter has found: each warning once as a VTK warning, and all in the field data of its
/// outputs, after those that the filters before have found and told.
inline void reportWarnings(
  vtkAlgorithm* filter, const Warnings& found, std::initializer_list<vtkDataObject*> outputs)
{
  for (vtkDataObject* output : outputs)
  {
    addWarnings(output->GetFieldData(), found);
  }
  for (const Warning& warning : found)
  {
    vtkWarningWithObjectMacro(filter, << warning.text);
  }
}
}

#endif
