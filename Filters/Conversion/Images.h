// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Images_h
#define Conversion_Images_h

#include "Images/VoxelMask.h"
#include "Imaging/ImageBoundary.h"

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

namespace medial
{
/// What tells the voxels of the solid.
struct SolidChoice
{
  enum Kind
  {
    Auto,     ///< the one label that there is
    IsoValue, ///< those of at least `value`
    Label     ///< those of `value`
  };
  Kind kind;
  double value; ///< no matter if Auto
};

/// @throw InvalidInput  there is no array with a number for each voxel, a value is NaN, the choice selects
///                      no voxel or all of them, or there is none and several are possible: lists them;
///                      the image is flat, or too large, or has no positive spacing
/// @param choice        if Auto, becomes what was chosen
VoxelMask readMask(vtkImageData* image, vtkDataArray* values, SolidChoice& choice);

/// Makes an extent of VTK, first and last i, j and k, larger on each side.
void padExtent(int extent[6], int margin);

/// The warnings with their places in space.
/// @param input  where the voxels are
Warnings warningsInSpace(const ImageBoundary& boundary, vtkImageData* input);

/// Writes surface and mask, as vtkImageBoundary.h describes them.
/// @param choice  what told the voxels of the solid
/// @param input   where the voxels are; its field data is passed on to both outputs
void write(const ImageBoundary& boundary, const SolidChoice& choice, vtkImageData* input,
  vtkPolyData* surface, vtkImageData* mask);
}

#endif
