// SPDX-License-Identifier: BSD-3-Clause
#ifndef MedialPruneTest_h
#define MedialPruneTest_h

#include "FilterTest.h"

#include <vtkPolyData.h>
#include <vtkTable.h>

/// What the tests of vtkMedialPrune share.
namespace medialPruneTest
{
using filterTest::boxPipeline;

/// The filter on the parts of the box, without a schedule.
inline vtkSmartPointer<vtkMedialPrune> pruneBox()
{
  auto filter = vtkSmartPointer<vtkMedialPrune>::New();
  filter->SetInputData(boxPipeline().parts->GetOutput());
  filter->ClearIterations();
  return filter;
}

inline vtkTable* history(vtkMedialPrune* filter)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
}

inline vtkPolyData* removed(vtkMedialPrune* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(2));
}
}

#endif
