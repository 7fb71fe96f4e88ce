// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadText_h
#define ReadText_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

/// The points and polygons of an ASCII .off file: OFF, NOFF, COFF, STOFF and their mixtures.
/// @throw InputError  names the line that can't be read, or says that there are fewer or more lines than
///                    the file's counts tell
vtkSmartPointer<vtkPolyData> readOff(const std::string& file);

/// The points of a text file with x y z in each line. Normals are columns that the first line names nx ny nz;
/// without names, columns 4 to 6 where there are six and all have length 1 up to a hundredth. Further columns,
/// empty lines and text after # are ignored. Columns are separated by blanks, commas or semicolons. The first line may be the number of
/// points, or name the columns if they begin with x y z.
/// @throw InputError  names the line that can't be read: it has no three numbers, or decimal commas; or
///                    says that the number of points is another one
vtkSmartPointer<vtkPolyData> readXyz(const std::string& file);

#endif
