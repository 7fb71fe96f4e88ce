// SPDX-License-Identifier: BSD-3-Clause
#ifndef DicomSeries_h
#define DicomSeries_h

#include <vtkDICOMReader.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

/// A reader of a series of DICOM images, with what the files' headers say.
/// @param path    a folder, or a file of several slices
/// @param series  which of the folder's series, from 1 on; 0: the only one
/// @throw InputError  there are none, or several; they have no place in space, colors, or several times;
///                    slices are missing
vtkSmartPointer<vtkDICOMReader> dicomReader(const std::string& path, int series);

/// @throw InputError  the files are too small for the images that their headers announce
void checkDicomBytes(vtkDICOMReader* reader);

/// Puts an image that such a reader has read to its place in the patient: x to the left, y to the back, z
/// to the head, in mm. Where the gantry was tilted, the axis across the slices is oblique.
void placeDicom(vtkDICOMReader* reader, vtkImageData* image);

#endif
