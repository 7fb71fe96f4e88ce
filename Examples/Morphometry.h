// SPDX-License-Identifier: BSD-3-Clause
#ifndef Morphometry_h
#define Morphometry_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

struct Arguments;
class vtkSimplifyShape;
class vtkTable;

/// What vtkMorphometry makes: the row of an object, and what its thickness and separation are means of.
struct MeasuredObject
{
  vtkSmartPointer<vtkTable> row, means;
};

/// Measures what an updated filter has made: the simplified solid.
/// @throw InputError  it can't be measured
MeasuredObject morphometryOf(vtkSimplifyShape* simplify, const Arguments& arguments);

/// The same for report.json: values and units by the names of the quantities.
/// @param row  null: was not asked for
std::string morphometryJson(vtkTable* row);

/// The columns of such a row in a file.
std::vector<std::string> morphometryColumns();

/// What an object is called: the name of its file or folder without folders and endings.
std::string objectName(const std::string& file);

/// The lines of --help about the quantities.
std::string quantityHelp();

#endif
