// SPDX-License-Identifier: BSD-3-Clause
#ifndef Remedies_h
#define Remedies_h

/// What to do about data that doesn't fit: how messages end.
namespace medial
{
constexpr const char* TakePolarBalls =
  "take the output of vtkPolarBalls as it is (files of an earlier version lack arrays: make them "
  "again)";

constexpr const char* TakeMedialAxis =
  "take the output of vtkMedialAxis or a later filter as it is (files of an earlier version lack "
  "arrays: make them again)";

constexpr const char* TakePowerCrust =
  "take the output of vtkPowerCrust or vtkSimplifyShape as it is, made with this axis";

constexpr const char* TakeParts = "take the output of vtkMedialPartDecomposition or vtkMedialPrune";
}

#endif
