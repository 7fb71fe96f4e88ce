// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Balls_h
#define Conversion_Balls_h

#include "Balls/PolarBalls.h"
#include "Base/Lists.h"
#include "Conversion/TetrahedraChecks.h"

#include <vector>

class vtkDataObject;
class vtkFieldData;
class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace medial
{
/// The points of a data set, in their order.
std::vector<Point> readSamples(vtkPointSet* input);

/// The normals at the points: the active ones, or the point array `Normals`. Empty where there are none.
/// @throw InvalidInput  the array has not three components, or not one normal for each point
std::vector<Point> readNormals(vtkPointSet* input);

/// The polygons of a data set, if it is a surface: the samples are its points then. Cells of other kinds,
/// and cells with a point that isn't there, are left out.
IndexLists readPolygons(vtkPointSet* input);

/// The unit to which the coordinates of points were rounded: of floats that of the largest coordinate, or
/// the field array `SampleResolution` where it is more; 0 where nothing is known.
/// @throw InvalidInput  the array does not hold one length
double sampleResolution(vtkPointSet* input);

/// Writes the balls and the samples, as vtkPolarBalls.h describes them.
/// @param input  its field data is passed on to both outputs, but not the verdict on an earlier surface
void write(const PolarBallsAndSamples& made, vtkPointSet* input, vtkUnstructuredGrid* balls,
  vtkPolyData* samples);

/// Passes the field data of an input on. It may be the surface of an earlier run: the verdict on that stays
/// behind.
void passInput(vtkDataObject* input, vtkFieldData* output);

/// @throw InvalidInput  an array is missing or does not fit
PolarBalls readPolarBalls(
  vtkUnstructuredGrid* input, CellNeighbors neighbors = CellNeighbors::Found);

/// Passes the field data of the balls on to an output made from them, but not the lists of samples and
/// balls: they are long, and what reads them reads the balls too.
void passFieldData(vtkUnstructuredGrid* balls, vtkFieldData* output);
}

#endif
