// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Thickness_h
#define Conversion_Thickness_h

#include "Measuring/ThicknessReport.h"

#include <vector>

class vtkDataSet;
class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace medial
{
/// The points of any data set.
/// @throw InvalidInput  a coordinate is not finite
std::vector<Point> readPlaces(vtkDataSet* input);

/// Writes the rows of means over the volume, as vtkLocalThickness.h describes them.
void writeMeans(const VolumeThickness& volume, vtkTable* means);

/// Writes what vtkLocalThickness.h describes.
/// @param places  where was measured; none: at the samples of the balls
/// @param axis    with the thin places; none: there is none
void write(const ThicknessReport& report, const PolarBalls& made, vtkUnstructuredGrid* balls,
  vtkDataSet* places, vtkPolyData* axis, vtkDataSet* measured, vtkTable* means,
  vtkTable* thinPlaces);
}

#endif
