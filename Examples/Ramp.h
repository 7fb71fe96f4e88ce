// SPDX-License-Identifier: BSD-3-Clause
#ifndef Ramp_h
#define Ramp_h

#include <vtkColorTransferFunction.h>
#include <vtkSmartPointer.h>

/// From dark blue over green to yellow, of steadily growing lightness, so that who sees few colours can tell them apart,
/// too; grey where there is no number.
/// @param isLogarithmic  a logarithmic scale, for positive bounds; else a linear one
vtkSmartPointer<vtkColorTransferFunction> ramp(double lower, double upper, bool isLogarithmic);

#endif
