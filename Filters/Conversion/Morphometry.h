// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Morphometry_h
#define Conversion_Morphometry_h

#include "Base/Types.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace medial
{
struct SurfaceTriangles
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

/// @throw InvalidInput  there are other cells than triangles, or an array does not fit
SurfaceTriangles readCrust(vtkPolyData* input);

/// Was the surface made from these balls? Then its points are their samples, where it says so.
bool isSurfaceOf(vtkUnstructuredGrid* balls, vtkPolyData* surface);

/// @throw InvalidInput  the surface was made from other balls
void checkSurfaceOf(vtkUnstructuredGrid* balls, vtkPolyData* surface);

/// One object's row of morphometry.
struct MorphometryRow
{
  std::string name;
  std::string unit;
  std::vector<double> values; ///< one for each quantity
};

/// Writes the row as vtkMorphometry.h describes it.
/// @param balls, surface  their field data is passed on; the surface tells Betti numbers and verdict
void write(
  const MorphometryRow& row, vtkUnstructuredGrid* balls, vtkPolyData* surface, vtkTable* output);
}

#endif
