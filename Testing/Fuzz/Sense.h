// SPDX-License-Identifier: BSD-3-Clause
#ifndef Sense_h
#define Sense_h

#include <string>

class vtkDataObject;
class vtkPolyData;

/// What is wrong with an output of a filter; empty: nothing.
namespace fuzz
{
/// After an error there are neither points, cells, rows nor arrays.
std::string leftOver(vtkDataObject* output);

/// Points are finite, corners are points, the columns of tables are finite.
std::string nonsense(vtkDataObject* output);

/// Measures of parts are finite.
std::string badMeasures(vtkDataObject* output);

/// A surface says that it is closed, is so, and encloses a positive volume.
std::string notSolid(vtkPolyData* surface);
}

#endif
