// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadPoints_h
#define ReadPoints_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

struct Input
{
  vtkSmartPointer<vtkPolyData>
    samples;             ///< points, and the polygons between them where the file has
                         ///< some and no point was left out
  vtkIdType invalid = 0; ///< points left out, because a coordinate is NaN or infinite
};

/// The points, and the polygons if it has them, of a .ply .stl .obj .vtp .vtu .off or .xyz file.
///
/// @param dropInvalid  leave points with a coordinate that is NaN or infinite out
/// @throw InputError  the file can't be read, or has such points that must not be left out; says why
Input readInput(const std::string& file, bool dropInvalid);

#endif
