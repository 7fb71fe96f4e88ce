// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadImage_h
#define ReadImage_h

#include "ImageFile.h"

/// The voxels of an image, see readImageFile().
///
/// VTK's readers work in a process of their own, as in ReadXml.h. What it may use depends on what the header
/// announces, once it is known that there is so much.
/// @throw InputError  the image can't be read; says why
vtkSmartPointer<vtkImageData> readImage(const ImageSource& source);

#endif
