// SPDX-License-Identifier: BSD-3-Clause
#include "ImageOptions.h"

#include "Arguments.h"
#include "Errors.h"
#include "ImageNames.h"
#include "Lines.h"

#include <cmath>

namespace
{
double parseGaussian(const std::string& word)
{
  double result = 0;
  if (!parseReal(word, result) || !(result >= 0 && result <= 10))
  {
    throw UsageError("--gaussian takes a number of voxels from 0 to 10, not '" + word + "'");
  }
  return result;
}

double parseValue(const char* option, const std::string& word)
{
  double value = 0;
  if (!parseReal(word, value) || !std::isfinite(value))
  {
    throw UsageError(std::string(option) + " takes a number, not '" + word + "'");
  }
  return value;
}

int parseVoxels(const char* option, const std::string& word)
{
  int voxels = 0;
  if (!parseCount(word, voxels))
  {
    throw UsageError(std::string(option) + " takes a number of voxels, not '" + word + "'");
  }
  return voxels;
}
}

std::vector<Option> imageOptions(Arguments& arguments)
{
  return {
    { "--iso", "X", "of an image: the solid are the voxels of at least the value X",
      [&](const std::string& value) { arguments.iso = parseValue("--iso", value); } },
    { "--label", "N",
      "of an image: the solid are the voxels of the value N (default: the one of two values\n"
      "that isn't 0)",
      [&](const std::string& value) { arguments.label = parseValue("--label", value); } },
    { "--series", "N",
      "of a folder of DICOM files: the one to take of several series, counted from 1",
      [&](const std::string& value) {
        if (!parseCount(value, arguments.series) || arguments.series < 1)
        {
          throw UsageError("--series takes a number from 1 on, not '" + value + "'");
        }
      } },
    { "--fill-cavities", "N", "fills cavities of at most N voxels (default: 50)",
      [&](const std::string& value) {
        arguments.fillCavities = parseVoxels("--fill-cavities", value);
      } },
    { "--no-fill", "", "fills none", [&](const std::string&) { arguments.fillCavities = 0; } },
    { "--pieces", "WHICH",
      "largest   keeps the largest connected piece of the voxels alone\n"
      "N         keeps those of at least N voxels (default: 50)",
      [&](const std::string& value) {
        arguments.largestPiece = value == "largest";
        if (!arguments.largestPiece)
        {
          arguments.smallestPiece = parseVoxels("--pieces", value);
        }
      } },
    { "--gaussian", "R", "smooths the voxels by a Gaussian of R voxels, at most 10 (default: 0.7)",
      [&](const std::string& value) { arguments.gaussian = parseGaussian(value); } },
  };
}

void checkImageOptions(const Arguments& arguments, const std::string& input)
{
  if (arguments.clean && imageKind(input) != ImageKind::None)
  {
    throw UsageError("--clean is for points; " + input + " is an image");
  }
  const bool isForImages = arguments.iso || arguments.label || arguments.fillCavities ||
    arguments.smallestPiece || arguments.largestPiece || arguments.gaussian;
  const ImageKind kind = imageKind(input);
  if (isForImages && kind == ImageKind::None)
  {
    throw UsageError("--iso, --label, --fill-cavities, --no-fill, --pieces and --gaussian are for "
                     "images: .vti .mha .mhd .nrrd .nii .nii.gz .dcm, or a folder of DICOM files");
  }
  if (arguments.series > 0 && kind != ImageKind::Dicom)
  {
    throw UsageError("--series is for a folder of DICOM files");
  }
}
