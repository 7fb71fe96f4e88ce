// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageNames_h
#define ImageNames_h

#include <string>

enum class ImageKind
{
  None,
  Xml,         ///< .vti
  Meta,        ///< .mha .mhd
  Nrrd,        ///< .nrrd
  Nifti,       ///< .nii
  PackedNifti, ///< .nii.gz
  Dicom        ///< .dcm, or a folder
};

/// What a file is by its name; None if it is no image.
ImageKind imageKind(const std::string& file);

#endif
