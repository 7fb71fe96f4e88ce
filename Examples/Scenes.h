// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scenes_h
#define Scenes_h

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;

// What each picture shows. `scale` is the number of pixels to a unit of line width.

/// The samples as dots, paler the farther away they are.
/// @param towardsViewer  direction of length 1
vtkSmartPointer<vtkActor> samplesActor(
  vtkPolyData* samples, const double towardsViewer[3], double scale);

/// The axis coloured by Radius: dark where the solid is thin, bright where it is thick.
vtkSmartPointer<vtkActor> axisActor(vtkPolyData* axis, double scale);

/// The axis coloured by PartId, neighbouring ids far apart.
vtkSmartPointer<vtkActor> partsActor(vtkPolyData* parts, double scale);

/// The axis coloured by an array of its cells, in equal ratios: what is below a thousandth of the
/// largest value is as dark as can be. PartId is coloured as by partsActor.
/// @throw InputError  there is no such array
vtkSmartPointer<vtkActor> arrayActor(vtkPolyData* axis, const std::string& array, double scale);

/// The closed surface, smoothly shaded.
vtkSmartPointer<vtkActor> surfaceActor(vtkPolyData* surface);

#endif
