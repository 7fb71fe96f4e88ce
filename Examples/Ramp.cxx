// SPDX-License-Identifier: BSD-3-Clause
#include "Ramp.h"

#include <vtkMath.h>

#include <array>
#include <cmath>

vtkSmartPointer<vtkColorTransferFunction> ramp(double lower, double upper, bool isLogarithmic)
{
  static const double lab[][3] = { { 30, 36, -58 }, { 42, 8, -46 }, { 55, -20, -24 },
    { 69, -42, 14 }, { 82, -28, 60 }, { 93, -6, 78 } };
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  colors->SetColorSpaceToLab();
  for (int i = 0; i < 6; ++i)
  {
    std::array<double, 3> rgb;
    vtkMath::LabToRGB(lab[i], rgb.data());
    const double value =
      isLogarithmic ? lower * std::pow(upper / lower, i / 5.0) : lower + (upper - lower) * i / 5;
    colors->AddRGBPoint(value, rgb[0], rgb[1], rgb[2]);
  }
  if (isLogarithmic)
  {
    colors->SetScaleToLog10();
  }
  colors->SetNanColor(0.6, 0.6, 0.6);
  return colors;
}
