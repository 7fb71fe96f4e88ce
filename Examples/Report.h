// SPDX-License-Identifier: BSD-3-Clause
#ifndef Report_h
#define Report_h

#include <vtkType.h>

#include <string>

struct Arguments;
struct Input;
class Progress;
class vtkSimplifyShape;
class vtkTable;

// All of these read the outputs of the filter's stages after an update.

/// The text of report.json; README.md describes its keys.
/// @param progress  has watched the stages
/// @param morphometry  null: was not asked for
/// @param total     seconds from the program's start to the end of the last stage
std::string report(vtkSimplifyShape* simplify, const Input& input, vtkTable* morphometry,
  const Progress& progress, double total);

/// The few lines that are printed at the end.
std::string summary(vtkSimplifyShape* simplify, const Input& input, const Arguments& arguments,
  vtkIdType axisTriangles, double total);

/// A count with commas between thousands.
std::string grouped(double count);

#endif
