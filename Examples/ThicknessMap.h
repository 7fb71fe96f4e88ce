// SPDX-License-Identifier: BSD-3-Clause
#ifndef ThicknessMap_h
#define ThicknessMap_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <vector>

class Progress;
class vtkSimplifyShape;

/// How thick a solid is, as vtkLocalThickness measures it.
struct ThicknessMap
{
  vtkSmartPointer<vtkPolyData> surface; ///< the simplified one, with Thickness at its points
  vtkSmartPointer<vtkPolyData> axis; ///< the pruned one; it has nothing but Thickness at its points
  vtkSmartPointer<vtkTable> means;
  vtkSmartPointer<vtkTable> thinPlaces;

  /// The largest thickness anywhere, which ends the scale of colours; positive.
  double top() const;
};

/// The distribution of a quantity over the volume: a row of the table of means.
struct VolumeMean
{
  double mean, deviation, smallest, largest; ///< not finite where there are no values
  double number;                             ///< of values
  std::vector<double> histogram;             ///< in equal ranges from 0 to the largest
};

/// @param quantity  "Thickness" or "Separation"
VolumeMean volumeMean(vtkTable* means, const char* quantity);

/// Measures the solid of the samples at the simplified surface and the pruned axis.
/// @param simplify  after an update
/// @param means     over the volume of the solid, where they are known; null: they are measured
/// @throw InputError  it can't be measured
ThicknessMap thicknessMap(vtkSimplifyShape* simplify, vtkTable* means, Progress& progress);

#endif
