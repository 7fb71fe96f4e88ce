// SPDX-License-Identifier: BSD-3-Clause
#ifndef Pictures_h
#define Pictures_h

#include <array>
#include <string>

class OutputFolder;
class vtkPolyData;

/// A stage of the pipeline that is drawn.
struct Stage
{
  std::string name;    ///< of the picture's file, without .png
  std::string caption; ///< in the overview
  vtkPolyData* data;
};

/// Samples, axis, parts, pruned axis and surface, in this order.
using Stages = std::array<Stage, 5>;

/// Draws a picture of each stage, all seen from the same place, and an overview with all five side by
/// side.
/// @throw InputError  a picture can't be written
void drawPictures(const Stages& stages, OutputFolder& folder);

#endif
