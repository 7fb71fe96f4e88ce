// SPDX-License-Identifier: BSD-3-Clause
#include "DicomSeries.h"

#include "Errors.h"

#include <vtkDICOMDirectory.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkErrorCode.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

namespace
{
using Vector = std::array<double, 3>;

Vector difference(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double length(const Vector& vector)
{
  return std::hypot(vector[0], vector[1], vector[2]);
}

/// The number, name and images of each series of a folder, one line each.
std::string listed(vtkDICOMDirectory* directory)
{
  constexpr int most = 30;
  std::ostringstream text;
  for (int i = 0; i < std::min(most, directory->GetNumberOfSeries()); ++i)
  {
    const vtkDICOMItem& record = directory->GetSeriesRecord(i);
    text << (i == 0 ? "" : "; ") << i + 1 << ": " << record.Get(DC::Modality).AsUTF8String() << " '"
         << record.Get(DC::SeriesDescription).AsUTF8String() << "', "
         << directory->GetFileNamesForSeries(i)->GetNumberOfValues() << " files";
  }
  return text.str();
}

/// The files of a series of a folder, see dicomReader().
vtkSmartPointer<vtkStringArray> filesOf(const std::string& folder, int series)
{
  constexpr int depth = 8; // folders in folders, as on the disks that hospitals hand out
  vtkNew<vtkDICOMDirectory> directory;
  directory->SetDirectoryName(folder.c_str());
  directory->SetScanDepth(depth);
  directory->IgnoreDicomdirOn(); // it may be of another disk; the files tell the same
  directory->Update();
  const int count = directory->GetNumberOfSeries();
  if (count == 0)
  {
    throw InputError("no DICOM images are in this folder");
  }
  if (series > count || (series == 0 && count > 1))
  {
    throw InputError(
      (series == 0 ? "the folder has several series of images, choose one by --series N: "
                   : "there is no series " + std::to_string(series) + ": ") +
      listed(directory));
  }
  return directory->GetFileNamesForSeries(std::max(series, 1) - 1);
}

/// Where the first voxel of a slice is; nothing if its file doesn't say.
std::optional<Vector> placeOf(vtkDICOMReader* reader, int slice)
{
  vtkDICOMMetaData* data = reader->GetMetaData();
  const vtkDICOMValue& value =
    data->Get(data->GetFileIndex(slice), data->GetFrameIndex(slice), DC::ImagePositionPatient);
  if (value.GetNumberOfValues() != 3)
  {
    return {};
  }
  return Vector{ value.GetDouble(0), value.GetDouble(1), value.GetDouble(2) };
}

int slices(vtkDICOMReader* reader)
{
  const int* extent = reader->GetDataExtent();
  return extent[5] - extent[4] + 1;
}

/// @throw InputError  the distances between slices differ: some are missing
void checkDistances(vtkDICOMReader* reader)
{
  constexpr double tolerance = 0.05; // of the distance; places are often rounded to 0.01 mm or more
  const auto first = placeOf(reader, 0), last = placeOf(reader, slices(reader) - 1);
  if (!first || !last)
  {
    throw InputError("its slices have no place in space (ImagePositionPatient)");
  }
  const double distance = length(difference(*last, *first)) / (slices(reader) - 1);
  for (int slice = 1; slice < slices(reader); ++slice)
  {
    const auto before = placeOf(reader, slice - 1), here = placeOf(reader, slice);
    const double found = before && here ? length(difference(*here, *before)) : 0;
    if (!(std::abs(found - distance) <= tolerance * distance))
    {
      std::ostringstream text;
      text << "slices are missing or repeated: slice " << slice + 1 << " of " << slices(reader)
           << " is " << found << " mm from the one before, on average they are " << distance
           << " mm apart";
      throw InputError(text.str());
    }
  }
}

std::string fileOf(vtkDICOMReader* reader, int instance)
{
  vtkStringArray* files = reader->GetFileNames();
  return files ? files->GetValue(instance) : std::string(reader->GetFileName());
}

/// @throw InputError  it is not one image in space with a number for each voxel
void checkKind(vtkDICOMReader* reader)
{
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InputError(vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()));
  }
  if (reader->GetNumberOfScalarComponents() != 1)
  {
    throw InputError("its images are in color");
  }
  if (reader->GetTimeDimension() > 1)
  {
    throw InputError("it has " + std::to_string(reader->GetTimeDimension()) +
      " images of each slice, of several times; keep those of one");
  }
  if (reader->GetStackIDs()->GetNumberOfValues() > 1)
  {
    throw InputError("it has " + std::to_string(reader->GetStackIDs()->GetNumberOfValues()) +
      " stacks of slices; keep those of one");
  }
  if (slices(reader) < 2)
  {
    throw InputError("it has one slice; take the folder of all");
  }
}
}

vtkSmartPointer<vtkDICOMReader> dicomReader(const std::string& path, int series)
{
  const auto reader = vtkSmartPointer<vtkDICOMReader>::New();
  if (std::filesystem::is_directory(path))
  {
    reader->SetFileNames(filesOf(path, series));
  }
  else
  {
    reader->SetFileName(path.c_str());
  }
  reader->SetMemoryRowOrderToFileNative();
  reader->UpdateInformation();
  checkKind(reader);
  checkDistances(reader);
  return reader;
}

void checkDicomBytes(vtkDICOMReader* reader)
{
  constexpr double mostPacking = 1000; // by all that DICOM knows
  vtkDICOMMetaData* data = reader->GetMetaData();
  const std::string syntax = data->Get(DC::TransferSyntaxUID).AsString();
  const std::string plain = "1.2.840.10008.1.2"; // and .1 and .2; packed are .4 and .5
  const bool isPlain = syntax == plain || syntax == plain + ".1" || syntax == plain + ".2";
  const double announced = double(data->Get(DC::Rows).AsInt()) * data->Get(DC::Columns).AsInt() *
    slices(reader) * data->Get(DC::BitsAllocated).AsInt() / 8;
  double size = 0;
  for (int i = 0; i < data->GetNumberOfInstances(); ++i)
  {
    size += static_cast<double>(std::filesystem::file_size(fileOf(reader, i)));
  }
  if (announced > (isPlain ? size : mostPacking * size))
  {
    std::ostringstream text;
    text << "its headers announce " << announced << " bytes of voxels, but there are less; files "
         << "were cut, or their headers are wrong";
    throw InputError(text.str());
  }
}

void placeDicom(vtkDICOMReader* reader, vtkImageData* image)
{
  const Vector first = *placeOf(reader, 0);
  const Vector across = difference(*placeOf(reader, slices(reader) - 1), first);
  image->SetOrigin(first.data());
  image->GetSpacing()[2] = length(across) / (slices(reader) - 1);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 2; ++column)
    {
      image->GetDirectionMatrix()->SetElement(
        row, column, reader->GetPatientMatrix()->GetElement(row, column));
    }
    image->GetDirectionMatrix()->SetElement(row, 2, across[row] / length(across));
  }
}
