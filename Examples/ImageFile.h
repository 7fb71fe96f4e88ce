// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageFile_h
#define ImageFile_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

/// Where an image is.
struct ImageSource
{
  std::string file; ///< or a folder of DICOM files
  int series;       ///< see DicomSeries.h
};

/// How many bytes the voxels of an image take by its header. Reads no more than that needs.
/// @throw InputError  the header can't be read, or announces more than there is in the file
double announcedBytes(const ImageSource& source);

/// The voxels of an image with origin, spacing and direction: those of VTK's reader, and where it leaves
/// them out, as they are in the header (sform or qform of NIfTI, whose values are rescaled, too).
/// @throw InputError  see announcedBytes(); or the voxels are damaged
vtkSmartPointer<vtkImageData> readImageFile(const ImageSource& source);

#endif
