// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageHeaders_h
#define ImageHeaders_h

#include <ios>
#include <string>

class vtkImageData;
class vtkNIFTIImageReader;

// What VTK 9.1's readers leave out of the headers of images.

/// Where the voxels of an image are.
struct VoxelData
{
  std::string file;     ///< the header's own, or another
  std::streamoff begin; ///< there
  enum
  {
    Raw,
    Deflated, ///< by gzip or zlib
    Text
  } kind;
};

/// Of a .mha or .mhd file.
VoxelData metaVoxels(const std::string& file);

/// Of a .nrrd file.
VoxelData nrrdVoxels(const std::string& file);

/// Sets the directions of the axes.
/// @throw InputError  they are degenerate
void placeMeta(const std::string& file, vtkImageData* image);

/// Sets origin, spacing, and the directions of the axes.
/// @throw InputError  they are degenerate
void placeNrrd(const std::string& file, vtkImageData* image);

/// Sets the origin and the directions of the axes, by the sform or else the qform. Rescales the values.
void placeNifti(vtkNIFTIImageReader* reader, vtkImageData* image);

#endif
