// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadImage_h
#define ReadImage_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

/// Is it the name of a .vti .mha .mhd .nrrd .nii or .nii.gz file?
bool isImageName(const std::string& file);

/// The voxels of such a file, with origin, spacing and direction: those of VTK's reader, and where it leaves
/// them out, as they are in the header (sform or qform of NIfTI, whose values are rescaled, too).
///
/// VTK's readers work in a process of their own, as in ReadXml.h.
/// @throw InputError  the file can't be read, or is shorter than its header says; says why
vtkSmartPointer<vtkImageData> readImage(const std::string& file);

#endif
