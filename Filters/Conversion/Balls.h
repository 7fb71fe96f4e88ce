// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Balls_h
#define Conversion_Balls_h

#include "Balls/PolarBalls.h"

#include <vector>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace medial
{
/// What to do about balls that don't fit.
constexpr const char* TakePolarBalls =
  "take the output of vtkPolarBalls as it is (files of an earlier version lack arrays: make them "
  "again)";

/// The points of a data set, in their order.
std::vector<Point> readSamples(vtkPointSet* input);

/// @param powerShape  Betti numbers of the power shape of `balls`
void write(const PolarBalls& balls, const Betti& powerShape, vtkPointSet* input,
  vtkUnstructuredGrid* output);
PolarBalls readPolarBalls(vtkUnstructuredGrid* input);
}

#endif
