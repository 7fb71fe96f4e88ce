// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFile.h"

#ifdef MEDIAL_WITH_DICOM
#include "DicomSeries.h"
#endif
#include "Errors.h"
#include "ImageHeaders.h"
#include "ImageNames.h"
#include "Inflation.h"
#include "Messages.h"

#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNrrdReader.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <sstream>

namespace
{
using Image = vtkSmartPointer<vtkImageData>;

/// An image whose header has been read.
struct OpenImage
{
  double bytes;                ///< that the voxels take
  std::function<void()> check; ///< throws InputError unless the file has so many
  std::function<Image()> read;
};

/// @throw InputError  VTK has said that something is wrong
void checkMessages(vtkAlgorithm* reader)
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

double voxelsOf(const int* extent)
{
  double result = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    result *= std::max(0.0, 1.0 + extent[2 * axis + 1] - extent[2 * axis]);
  }
  return result;
}

double bytesOf(vtkImageReader2* reader)
{
  return voxelsOf(reader->GetDataExtent()) * reader->GetNumberOfScalarComponents() *
    vtkDataArray::GetDataTypeSize(reader->GetDataScalarType());
}

void checkBytes(const VoxelData& data, double announced)
{
  constexpr double mostPerCharacter = 4; // "0 " can be a double
  std::error_code error;
  const auto size = static_cast<double>(std::filesystem::file_size(data.file, error));
  const double most = data.kind == VoxelData::Text ? mostPerCharacter * size : size;
  const bool isThere = !error &&
    (data.kind == VoxelData::Deflated ? inflatesTo(data.file, data.begin, announced)
                                      : announced <= most);
  if (!isThere)
  {
    std::ostringstream text;
    text << "its header announces " << announced << " bytes of voxels, but there are less; it was "
         << "cut, or the header is wrong";
    throw InputError(text.str());
  }
}

/// @param place  puts the image to its place in space
template <typename Reader, typename Place>
OpenImage opened(const std::string& file, const VoxelData& data, const Place& place)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  if (!reader->CanReadFile(file.c_str()))
  {
    throw InputError("it is not what its name says, or its header is damaged");
  }
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  checkMessages(reader);
  const double bytes = bytesOf(reader);
  return { bytes, [data, bytes] { checkBytes(data, bytes); },
    [reader, place] {
      reader->Update();
      checkMessages(reader);
      place(reader, reader->GetOutput());
      return Image(reader->GetOutput());
    } };
}

/// The array with the voxels in a .vti file: the scalars, else the first one of the points.
vtkInformation* voxelArray(vtkXMLImageDataReader* reader)
{
  vtkInformationVector* arrays =
    reader->GetOutputInformation(0)->Get(vtkDataObject::POINT_DATA_VECTOR());
  const int count = arrays ? arrays->GetNumberOfInformationObjects() : 0;
  for (int i = 0; i < count; ++i)
  {
    vtkInformation* array = arrays->GetInformationObject(i);
    const int active = array->Get(vtkDataObject::FIELD_ACTIVE_ATTRIBUTE());
    if ((active & (1 << vtkDataSetAttributes::SCALARS)) != 0)
    {
      return array;
    }
  }
  if (count == 0)
  {
    throw InputError("no array has a value for each voxel, as point data");
  }
  return arrays->GetInformationObject(0);
}

OpenImage openedXml(const std::string& file)
{
  const auto reader = vtkSmartPointer<vtkXMLImageDataReader>::New();
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  checkMessages(reader);
  vtkInformation* array = voxelArray(reader);
  const std::string name = array->Get(vtkDataObject::FIELD_NAME());
  reader->GetPointDataArraySelection()->DisableAllArrays();
  reader->GetPointDataArraySelection()->EnableArray(name.c_str());
  reader->GetCellDataArraySelection()->DisableAllArrays();
  const int* whole =
    reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  const double bytes = voxelsOf(whole) * array->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()) *
    vtkDataArray::GetDataTypeSize(array->Get(vtkDataObject::FIELD_ARRAY_TYPE()));
  const std::array<int, 6> last = { whole[1], whole[1], whole[3], whole[3], whole[5], whole[5] };
  return { bytes,
    [reader, last] {
      // VTK finds it where the file has all the others, too.
      static_cast<vtkAlgorithm*>(reader)->UpdateExtent(last.data());
      checkMessages(reader);
    },
    [reader, name] {
      reader->Update();
      checkMessages(reader);
      reader->GetOutput()->GetPointData()->SetActiveScalars(name.c_str());
      return Image(reader->GetOutput());
    } };
}

#ifdef MEDIAL_WITH_DICOM
OpenImage openedDicom(const ImageSource& source)
{
  const auto reader = dicomReader(source.file, source.series);
  checkMessages(reader);
  return { bytesOf(reader), [reader] { checkDicomBytes(reader); },
    [reader] {
      reader->Update();
      checkMessages(reader);
      placeDicom(reader, reader->GetOutput());
      return Image(reader->GetOutput());
    } };
}
#else
OpenImage openedDicom(const ImageSource&)
{
  throw InputError("this SimplifyShape reads no DICOM: it was built without vtk-dicom");
}
#endif

OpenImage opened(const ImageSource& source)
{
  const std::string& file = source.file;
  switch (imageKind(file))
  {
    case ImageKind::Xml:
      return openedXml(file);
    case ImageKind::Nrrd:
      return opened<vtkNrrdReader>(file, nrrdVoxels(file),
        [file](vtkNrrdReader*, vtkImageData* image) { placeNrrd(file, image); });
    case ImageKind::Meta:
      return opened<vtkMetaImageReader>(file, metaVoxels(file),
        [file](vtkMetaImageReader*, vtkImageData* image) { placeMeta(file, image); });
    case ImageKind::Nifti:
      return opened<vtkNIFTIImageReader>(file, { file, 0, VoxelData::Raw }, placeNifti);
    case ImageKind::PackedNifti:
      return opened<vtkNIFTIImageReader>(file, { file, 0, VoxelData::Deflated }, placeNifti);
    default:
      return openedDicom(source);
  }
}
}

double announcedBytes(const ImageSource& source)
{
  const OpenImage image = opened(source);
  image.check();
  return image.bytes;
}

vtkSmartPointer<vtkImageData> readImageFile(const ImageSource& source)
{
  const Image image = opened(source).read();
  if (!image->GetPointData()->GetScalars())
  {
    throw InputError("there are no voxels in it");
  }
  return image;
}
