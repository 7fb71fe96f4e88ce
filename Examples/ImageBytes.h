// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageBytes_h
#define ImageBytes_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

/// The voxels of an image with its place, as one process gives them to another.
std::string bytesOf(vtkImageData* image);

/// The reverse of bytesOf().
vtkSmartPointer<vtkImageData> imageOf(const std::string& bytes);

#endif
