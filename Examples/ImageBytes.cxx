// SPDX-License-Identifier: BSD-3-Clause
#include "ImageBytes.h"

#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace
{
/// What comes before the voxels.
struct Header
{
  std::array<int, 6> extent;
  int type;
  int components;
  std::array<double, 3> origin, spacing;
  std::array<double, 9> direction;
};
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
  const auto size =
    static_cast<std::size_t>(values->GetNumberOfValues() * values->GetDataTypeSize());
  std::string result;
  result.reserve(sizeof header + size);
  result.append(reinterpret_cast<const char*>(&header), sizeof header);
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
