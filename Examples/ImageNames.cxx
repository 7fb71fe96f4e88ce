// SPDX-License-Identifier: BSD-3-Clause
#include "ImageNames.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

ImageKind imageKind(const std::string& file)
{
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
  {
    return ImageKind::Dicom;
  }
  std::string name = file;
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static const std::pair<std::string, ImageKind> endings[] = {
    { ".vti", ImageKind::Xml },
    { ".mha", ImageKind::Meta },
    { ".mhd", ImageKind::Meta },
    { ".nrrd", ImageKind::Nrrd },
    { ".nii", ImageKind::Nifti },
    { ".nii.gz", ImageKind::PackedNifti },
    { ".dcm", ImageKind::Dicom },
  };
  for (const auto& [ending, kind] : endings)
  {
    if (name.size() >= ending.size() &&
      name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
    {
      return kind;
    }
  }
  return ImageKind::None;
}
