// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadText_h
#define ReadText_h

#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <string>

/// The points of an ASCII .off file: OFF, NOFF, COFF, STOFF and their mixtures.
/// @throw InputError  names the line that can't be read
vtkSmartPointer<vtkPoints> readOff(const std::string& file);

/// The points of a text file with x y z in each line. Further columns, empty lines and text after # are
/// ignored. Columns are separated by blanks, commas or semicolons.
/// @throw InputError  names the line that can't be read
vtkSmartPointer<vtkPoints> readXyz(const std::string& file);

#endif
