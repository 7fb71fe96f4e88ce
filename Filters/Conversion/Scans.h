// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Scans_h
#define Conversion_Scans_h

#include "Samples/CleanScan.h"

class vtkPointSet;
class vtkPolyData;

namespace medial
{
/// Writes the samples, as vtkCleanScan.h describes them.
/// @param input  its field data is passed on, and its normals, if there are no others
/// @throw InvalidInput  its normals don't fit, see readNormals()
void write(const CleanScan& made, vtkPointSet* input, vtkPolyData* output);
}

#endif
