// SPDX-License-Identifier: BSD-3-Clause
#ifndef Pipeline_h
#define Pipeline_h

#include <vtkMedialAxis.h>
#include <vtkMedialPartDecomposition.h>
#include <vtkMedialPrune.h>
#include <vtkNew.h>
#include <vtkPolarBalls.h>
#include <vtkPowerCrust.h>

struct Arguments;
class Progress;
class vtkDataObject;
class vtkPointSet;

/// From samples to a simplified surface: the five filters, connected, and how long each took.
struct Pipeline
{
  Pipeline(vtkPointSet* samples, const Arguments& arguments);

  /// Runs all filters.
  /// @throw InputError  a filter can't use what it gets
  /// @throw UsageError  a part to be removed isn't there
  void run(Progress& progress, const Arguments& arguments);

  vtkNew<vtkPolarBalls> balls;
  vtkNew<vtkMedialAxis> axis;
  vtkNew<vtkMedialPartDecomposition> parts;
  vtkNew<vtkMedialPrune> prune;
  vtkNew<vtkPowerCrust> crustBefore; ///< of all inner balls
  vtkNew<vtkPowerCrust> crust;       ///< of the pruned axis

  struct
  {
    double polarBalls, medialAxis, parts, prune, crust;
  } seconds = {};
};

/// One number of an output's field data.
/// @throw InputError  the array isn't there
double fieldValue(vtkDataObject* output, const char* array, int component = 0);

#endif
