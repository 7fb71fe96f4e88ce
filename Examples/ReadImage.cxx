// SPDX-License-Identifier: BSD-3-Clause
#include "ReadImage.h"

#include "ChildProcess.h"
#include "Errors.h"
#include "Messages.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace
{
/// What goes from one process to the other, before the voxels.
struct Header
{
  std::array<int, 6> extent;
  int type;
  int components;
  std::array<double, 3> origin, spacing;
  std::array<double, 9> direction;
};

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The value of a line "key = value" or "key: value" in the header that a file begins with; empty if there
/// is none.
std::string headerValue(const std::string& file, const std::string& key, char separator)
{
  std::ifstream in(file, std::ios::binary);
  std::string line;
  for (int i = 0; i < 200 && std::getline(in, line); ++i)
  {
    const std::size_t end = line.find(separator);
    std::string found = lowerCase(line.substr(0, end));
    found.erase(found.find_last_not_of(" \t") + 1);
    if (end != std::string::npos && found == key)
    {
      return line.substr(end + 1);
    }
  }
  return "";
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

/// VTK 9.1's reader leaves the directions out.
void addMetaDirection(const std::string& file, vtkImageData* image)
{
  const std::vector<double> axes = numbersIn(headerValue(file, "transformmatrix", '='));
  if (axes.size() == 9)
  {
    setAxes(image, axes, false);
  }
}

/// VTK 9.1's reader leaves the directions out.
void addNrrdDirection(const std::string& file, vtkImageData* image)
{
  const std::vector<double> axes = numbersIn(headerValue(file, "space directions", ':'));
  const std::vector<double> origin = numbersIn(headerValue(file, "space origin", ':'));
  if (axes.size() == 9)
  {
    setAxes(image, axes, true);
  }
  if (origin.size() == 3)
  {
    image->SetOrigin(origin.data());
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

/// VTK's reader tells where the image is, but leaves it at the origin.
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

/// @throw InputError  VTK has said that something is wrong
void checkRead(vtkAlgorithm* reader)
{
  if (!messages::error().empty())
  {
    throw InputError(messages::error());
  }
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InputError(vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()));
  }
}

/// Refuses a header that announces more than the file can hold, before memory is taken for it.
/// @param isPacked  the voxels are compressed; by deflate at most to a thousandth
void checkSize(vtkImageReader2* reader, const std::string& file, bool isPacked)
{
  const int* extent = reader->GetDataExtent();
  double announced = reader->GetNumberOfScalarComponents() *
    vtkDataArray::GetDataTypeSize(reader->GetDataScalarType());
  for (int axis = 0; axis < 3; ++axis)
  {
    announced *= std::max(0.0, 1.0 + extent[2 * axis + 1] - extent[2 * axis]);
  }
  std::error_code error;
  const auto size = static_cast<double>(std::filesystem::file_size(file, error));
  if (error || announced > (isPacked ? 1100 * size : size))
  {
    std::ostringstream text;
    text << "its header announces " << announced << " bytes of voxels, but the file has " << size;
    throw InputError(text.str());
  }
}

/// The file with the voxels of a header that has its own file.
std::string dataFile(const std::string& file, const std::string& name)
{
  std::string trimmed = name;
  trimmed.erase(0, std::min(trimmed.find_first_not_of(" \t"), trimmed.size()));
  trimmed.erase(trimmed.find_last_not_of(" \t\r") + 1);
  const bool isHere = trimmed.empty() || lowerCase(trimmed) == "local";
  return isHere ? file : (std::filesystem::path(file).parent_path() / trimmed).string();
}

template <typename Reader, typename Place>
vtkSmartPointer<vtkImageData> readWith(
  const std::string& file, const std::string& voxels, bool isPacked, const Place& place)
{
  vtkNew<Reader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    throw InputError("it is not what its name says, or its header is damaged");
  }
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  checkRead(reader);
  checkSize(reader, voxels, isPacked);
  reader->Update();
  checkRead(reader);
  const vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  if (!image->GetPointData()->GetScalars())
  {
    throw InputError("there are no voxels in it");
  }
  place(reader.Get(), image.Get());
  return image;
}

vtkSmartPointer<vtkImageData> readXml(const std::string& file)
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  checkRead(reader);
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  vtkPointData* data = image->GetPointData();
  if (!data->GetScalars() && data->GetNumberOfArrays() > 0)
  {
    data->SetScalars(data->GetArray(0));
  }
  if (!data->GetScalars())
  {
    throw InputError("no array has a value for each voxel, as point data");
  }
  return image;
}

vtkSmartPointer<vtkImageData> readHere(const std::string& file)
{
  const std::string name = lowerCase(file);
  if (endsWith(name, ".vti"))
  {
    return readXml(file);
  }
  if (endsWith(name, ".nrrd"))
  {
    const bool isRaw = headerValue(file, "encoding", ':').find("raw") != std::string::npos;
    return readWith<vtkNrrdReader>(file, dataFile(file, headerValue(file, "data file", ':')),
      !isRaw, [&](vtkNrrdReader*, vtkImageData* image) { addNrrdDirection(file, image); });
  }
  if (endsWith(name, ".mha") || endsWith(name, ".mhd"))
  {
    const bool isPacked =
      lowerCase(headerValue(file, "compresseddata", '=')).find("true") != std::string::npos;
    return readWith<vtkMetaImageReader>(file,
      dataFile(file, headerValue(file, "elementdatafile", '=')), isPacked,
      [&](vtkMetaImageReader*, vtkImageData* image) { addMetaDirection(file, image); });
  }
  return readWith<vtkNIFTIImageReader>(file, file, endsWith(name, ".gz"), placeNifti);
}

std::string bytesOf(vtkImageData* image)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  Header header{};
  image->GetExtent(header.extent.data());
  header.type = values->GetDataType();
  header.components = values->GetNumberOfComponents();
  image->GetOrigin(header.origin.data());
  image->GetSpacing(header.spacing.data());
  std::copy_n(image->GetDirectionMatrix()->GetData(), 9, header.direction.data());
  std::string result(reinterpret_cast<const char*>(&header), sizeof header);
  const auto size =
    static_cast<std::size_t>(values->GetNumberOfValues() * values->GetDataTypeSize());
  return result.append(static_cast<const char*>(values->GetVoidPointer(0)), size);
}

vtkSmartPointer<vtkImageData> imageOf(const std::string& bytes)
{
  Header header{};
  std::memcpy(&header, bytes.data(), sizeof header);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(header.extent.data());
  image->SetOrigin(header.origin.data());
  image->SetSpacing(header.spacing.data());
  image->SetDirectionMatrix(header.direction.data());
  image->AllocateScalars(header.type, header.components);
  std::memcpy(
    image->GetScalarPointer(), bytes.data() + sizeof header, bytes.size() - sizeof header);
  return image;
}
}

bool isImageName(const std::string& file)
{
  const std::string name = lowerCase(file);
  const auto endings = { ".vti", ".mha", ".mhd", ".nrrd", ".nii", ".nii.gz" };
  return std::any_of(
    endings.begin(), endings.end(), [&name](const char* ending) { return endsWith(name, ending); });
}

vtkSmartPointer<vtkImageData> readImage(const std::string& file)
{
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  const std::size_t megabytes = error ? 1000 : static_cast<std::size_t>(size >> 20);
  const Limits limits = { (1000 + 200 * megabytes) << 20,
    0.7 + 0.25 * static_cast<double>(megabytes) };
  ChildResult result = inChildProcess([&] { return bytesOf(readHere(file)); }, limits);
  if (result.ending == Ending::Died)
  {
    throw InputError(file +
      ": VTK's reader crashes, or takes too much time or memory; the file is damaged: write it "
      "anew");
  }
  if (result.ending == Ending::Threw)
  {
    throw InputError(file + ": can't be read: " + result.text);
  }
  return imageOf(result.text);
}
