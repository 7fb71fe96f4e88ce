// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scenes_h
#define Scenes_h

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;

// The objects that pictures show. `scale` multiplies the widths of lines and the sizes of dots.

/// The samples as dots; those farther away are paler.
/// @param towardsViewer  direction of length 1
vtkSmartPointer<vtkActor> samplesActor(
  vtkPolyData* samples, const double towardsViewer[3], double scale);

/// The axis coloured by Radius: dark where the solid is thin, bright where it is thick.
vtkSmartPointer<vtkActor> axisActor(vtkPolyData* axis, double scale);

/// The axis coloured by PartId, in the colours of vtkMedialPartDecomposition::GetPartColor().
vtkSmartPointer<vtkActor> partsActor(vtkPolyData* parts, double scale);

/// The axis coloured by an array of its cells on a logarithmic scale, from a thousandth of the largest
/// value to the largest. PartId is coloured as by partsActor().
/// @throw InputError  there is no such array
vtkSmartPointer<vtkActor> arrayActor(vtkPolyData* axis, const std::string& array, double scale);

/// The closed surface, smoothly shaded.
vtkSmartPointer<vtkActor> surfaceActor(vtkPolyData* surface);

/// The surface and the axis coloured by Thickness of their points, from dark at 0 to bright at `top`, see Ramp.h.
vtkSmartPointer<vtkActor> thickSurfaceActor(vtkPolyData* surface, double top);
vtkSmartPointer<vtkActor> thickAxisActor(vtkPolyData* axis, double top, double scale);

#endif
