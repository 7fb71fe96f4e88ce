// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadPoints_h
#define ReadPoints_h

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

struct Input
{
  /// Points, their normals, and the polygons between them.
  vtkSmartPointer<vtkPolyData> samples;
  vtkSmartPointer<vtkImageData> image; ///< instead of samples, where the file has voxels
  vtkIdType invalid = 0;               ///< points left out, because a coordinate is NaN or infinite
  vtkIdType invalidPolygons = 0;       ///< polygons left out, because such a point is a corner
};

/// The points of a .ply .stl .obj .vtp .vtu .off .xyz or .csv file, its polygons, which name existing points, and
/// its normals, where it has some. Or the voxels of an image, see ReadImage.h.
///
/// @param series       of a folder of DICOM files, see DicomSeries.h
/// @param dropInvalid  leave points with a coordinate that is NaN or infinite out, and the polygons at them
/// @throw InputError  the file can't be read, or has such points that must not be left out; says why
Input readInput(const std::string& file, int series, bool dropInvalid);

#endif
