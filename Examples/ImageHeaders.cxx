// SPDX-License-Identifier: BSD-3-Clause
#include "ImageHeaders.h"

#include "Errors.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace
{
std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string trimmed(const std::string& text)
{
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r"), text.size());
  return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

struct HeaderLine
{
  std::string value;  ///< empty if there is no such line
  std::streamoff end; ///< where the next line begins in the file
};

/// The line "key = value" or "key: value" in the header that a file begins with.
HeaderLine headerLine(const std::string& file, const std::string& key, char separator)
{
  constexpr int mostLines = 200;
  std::ifstream in(file, std::ios::binary);
  std::string line;
  for (int i = 0; i < mostLines && std::getline(in, line); ++i)
  {
    const std::size_t end = line.find(separator);
    if (end != std::string::npos && lowerCase(trimmed(line.substr(0, end))) == key)
    {
      return { trimmed(line.substr(end + 1)), in.tellg() };
    }
  }
  return { "", 0 };
}

/// Where the header of a NRRD file ends: at an empty line.
std::streamoff nrrdEnd(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string line;
  while (std::getline(in, line) && !trimmed(line).empty())
  {
  }
  return in ? static_cast<std::streamoff>(in.tellg()) : 0;
}

/// A file that is named in the header of another.
std::string beside(const std::string& file, const std::string& name)
{
  return (std::filesystem::path(file).parent_path() / name).string();
}

/// All numbers of a text, whatever else is between them.
std::vector<double> numbersIn(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::istringstream in(text);
  std::vector<double> result;
  for (double number = 0; in >> number;)
  {
    result.push_back(number);
  }
  return result;
}

/// Sets the axes of an image from vectors along i, j and k.
/// @param withSpacing  their lengths are the spacing
void setAxes(vtkImageData* image, const std::vector<double>& axes, bool withSpacing)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* vector = axes.data() + static_cast<std::ptrdiff_t>(3 * axis);
    const double length = std::hypot(vector[0], vector[1], vector[2]);
    if (!(length > 0))
    {
      throw InputError("the directions of its axes are degenerate");
    }
    for (int k = 0; k < 3; ++k)
    {
      image->GetDirectionMatrix()->SetElement(k, axis, vector[k] / length);
    }
    if (withSpacing)
    {
      image->GetSpacing()[axis] = length;
    }
  }
}

void rescale(vtkImageData* image, double slope, double intercept)
{
  vtkDataArray* stored = image->GetPointData()->GetScalars();
  if (slope == 0 || (slope == 1 && intercept == 0) || stored->GetNumberOfComponents() != 1)
  {
    return;
  }
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(stored->GetNumberOfTuples());
  for (vtkIdType i = 0; i < stored->GetNumberOfTuples(); ++i)
  {
    values->SetValue(i, static_cast<float>(slope * stored->GetComponent(i, 0) + intercept));
  }
  image->GetPointData()->SetScalars(values);
}
}

VoxelData metaVoxels(const std::string& file)
{
  const HeaderLine data = headerLine(file, "elementdatafile", '=');
  const bool isDeflated =
    lowerCase(headerLine(file, "compresseddata", '=').value).find("true") != std::string::npos;
  const bool isText =
    lowerCase(headerLine(file, "binarydata", '=').value).find("false") != std::string::npos;
  const auto kind = isDeflated ? VoxelData::Deflated : isText ? VoxelData::Text : VoxelData::Raw;
  if (data.value.empty() || lowerCase(data.value) == "local")
  {
    return { file, data.end, kind };
  }
  return { beside(file, data.value), 0, kind };
}

VoxelData nrrdVoxels(const std::string& file)
{
  const std::string data = headerLine(file, "data file", ':').value;
  const std::string encoding = lowerCase(headerLine(file, "encoding", ':').value);
  const auto kind = encoding == "raw"        ? VoxelData::Raw
    : encoding == "gz" || encoding == "gzip" ? VoxelData::Deflated
                                             : VoxelData::Text;
  if (data.empty())
  {
    return { file, nrrdEnd(file), kind };
  }
  return { beside(file, data), 0, kind };
}

void placeMeta(const std::string& file, vtkImageData* image)
{
  const std::vector<double> axes = numbersIn(headerLine(file, "transformmatrix", '=').value);
  if (axes.size() == 9)
  {
    setAxes(image, axes, false);
  }
}

void placeNrrd(const std::string& file, vtkImageData* image)
{
  const std::vector<double> axes = numbersIn(headerLine(file, "space directions", ':').value);
  const std::vector<double> origin = numbersIn(headerLine(file, "space origin", ':').value);
  if (axes.size() == 9)
  {
    setAxes(image, axes, true);
  }
  if (origin.size() == 3)
  {
    image->SetOrigin(origin.data());
  }
}

void placeNifti(vtkNIFTIImageReader* reader, vtkImageData* image)
{
  rescale(image, reader->GetRescaleSlope(), reader->GetRescaleIntercept());
  vtkMatrix4x4* place =
    reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  for (int row = 0; place && row < 3; ++row)
  {
    image->GetOrigin()[row] = place->GetElement(row, 3);
    for (int column = 0; column < 3; ++column)
    {
      image->GetDirectionMatrix()->SetElement(row, column, place->GetElement(row, column));
    }
  }
}
