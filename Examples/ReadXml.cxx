// SPDX-License-Identifier: BSD-3-Clause
#include "ReadXml.h"

#include "ChildProcess.h"
#include "Errors.h"
#include "Messages.h"

#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cstring>
#include <filesystem>
#include <optional>

namespace
{
/// The coordinates as bytes, with 'f' or 'd' before them.
std::string bytesOf(vtkPoints* points)
{
  const int type = points->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
  vtkNew<vtkPoints> copy; // in plain order, and not of integers
  copy->SetDataType(type);
  copy->DeepCopy(points);
  vtkDataArray* values = copy->GetData();
  const std::size_t size = static_cast<std::size_t>(values->GetNumberOfValues()) *
    static_cast<std::size_t>(values->GetDataTypeSize());
  std::string bytes(1 + size, type == VTK_FLOAT ? 'f' : 'd');
  if (size > 0)
  {
    std::memcpy(&bytes[1], values->GetVoidPointer(0), size);
  }
  return bytes;
}

vtkSmartPointer<vtkPolyData> pointsOf(const std::string& bytes)
{
  const int type = bytes[0] == 'f' ? VTK_FLOAT : VTK_DOUBLE;
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  const std::size_t size = 3 * (type == VTK_FLOAT ? sizeof(float) : sizeof(double));
  points->SetNumberOfPoints(static_cast<vtkIdType>((bytes.size() - 1) / size));
  if (bytes.size() > 1)
  {
    std::memcpy(points->GetVoidPointer(0), &bytes[1], bytes.size() - 1);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  return result;
}

/// A reader that also notices what VTK's leaves out without a word: points beyond the number that the file
/// announces.
template <typename Reader>
class WholePoints : public Reader
{
public:
  static WholePoints* New()
  {
    auto* result = new WholePoints;
    result->InitializeObjectBase();
    return result;
  }

  /// Set if there are more points: the announced number.
  std::optional<vtkIdType> exceeded;

protected:
  int ReadPieceData() override
  {
    const int isRead = Reader::ReadPieceData();
    const vtkIdType count = this->NumberOfPoints[this->Piece];
    vtkXMLDataElement* points = this->PointElements[this->Piece];
    int type = VTK_VOID;
    if (isRead && points && points->GetNumberOfNestedElements() == 1 &&
      points->GetNestedElement(0)->GetWordTypeAttribute("type", type))
    {
      const auto next = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
      next->SetNumberOfValues(1);
      const bool isMore = this->ReadArrayValues(points->GetNestedElement(0), 0, next, 3 * count, 1);
      this->exceeded = isMore ? count : this->exceeded;
    }
    return isRead;
  }
};

template <typename Reader>
std::string read(const std::string& file)
{
  vtkNew<WholePoints<Reader>> reader;
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  reader->GetPointDataArraySelection()->DisableAllArrays(); // only the points are wanted
  reader->GetCellDataArraySelection()->DisableAllArrays();
  reader->Update();
  if (!messages::error().empty())
  {
    throw InputError(messages::error());
  }
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InputError(vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()));
  }
  if (reader->exceeded)
  {
    throw InputError("there are more points than NumberOfPoints, " +
      std::to_string(*reader->exceeded) + "; correct it");
  }
  vtkPoints* points = reader->GetOutput() ? reader->GetOutput()->GetPoints() : nullptr;
  return points ? bytesOf(points) : "d";
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> readApart(const std::string& file)
{
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  // Compressed data grow by the factor 1000 at most, points by much less.
  const std::size_t megabytes = error ? 1000 : static_cast<std::size_t>(size >> 20);
  const Limits limits = { (500 + 200 * megabytes) << 20,
    0.5 + 0.25 * static_cast<double>(megabytes) };
  ChildResult result = inChildProcess([&] { return read<Reader>(file); }, limits);
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
  return pointsOf(result.text);
}
}

vtkSmartPointer<vtkPolyData> readVtp(const std::string& file)
{
  return readApart<vtkXMLPolyDataReader>(file);
}

vtkSmartPointer<vtkPolyData> readVtu(const std::string& file)
{
  return readApart<vtkXMLUnstructuredGridReader>(file);
}
