// SPDX-License-Identifier: BSD-3-Clause
#include "ReadXml.h"

#include "ChildProcess.h"
#include "Errors.h"
#include "Messages.h"
#include "SurfaceBytes.h"

#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <filesystem>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace
{
/// The cells of a piece of a file, and their announced number.
using Announced = std::pair<vtkXMLDataElement*, vtkIdType>;

/// A reader that also notices what VTK's leaves out without a word: points and cells beyond the number that the
/// file announces.
template <typename Reader>
class WholeReader : public Reader
{
public:
  static WholeReader* New()
  {
    auto* result = new WholeReader;
    result->InitializeObjectBase();
    return result;
  }

  /// Empty if there are no more; else what of, and their announced number.
  std::string exceeded;

protected:
  int ReadPieceData() override
  {
    const int isRead = Reader::ReadPieceData();
    vtkXMLDataElement* points = this->PointElements[this->Piece];
    if (isRead && points && points->GetNumberOfNestedElements() == 1)
    {
      const vtkIdType count = this->NumberOfPoints[this->Piece];
      this->check("points than NumberOfPoints", points->GetNestedElement(0), 3, count);
    }
    for (const auto& [cells, count] : this->surfaceCells())
    {
      if (isRead && cells && count >= 0)
      {
        vtkXMLDataElement* offsets = this->FindDataArrayWithName(cells, "offsets");
        this->check("cells than announced", offsets, 1, count);
        const double end = count > 0 ? this->value(offsets, count - 1).value_or(0) : 0;
        this->check("corners of cells than their offsets tell",
          this->FindDataArrayWithName(cells, "connectivity"), 1, static_cast<vtkIdType>(end));
      }
    }
    return isRead;
  }

private:
  std::vector<Announced> surfaceCells() const
  {
    if constexpr (std::is_same_v<Reader, vtkXMLPolyDataReader>)
    {
      return { { this->PolyElements[this->Piece], this->NumberOfPolys[this->Piece] },
        { this->StripElements[this->Piece], this->NumberOfStrips[this->Piece] } };
    }
    else
    {
      return { { this->CellElements[this->Piece], this->NumberOfCells[this->Piece] } };
    }
  }

  /// Nothing if the array has no such value.
  std::optional<double> value(vtkXMLDataElement* array, vtkIdType place)
  {
    int type = VTK_VOID;
    if (!array || !array->GetWordTypeAttribute("type", type))
    {
      return {};
    }
    const auto found = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    found->SetNumberOfValues(1);
    const bool isThere = this->ReadArrayValues(array, 0, found, place, 1) != 0;
    return isThere ? std::optional(found->GetComponent(0, 0)) : std::nullopt;
  }

  /// Is there something in the array beyond `count` tuples?
  void check(const char* what, vtkXMLDataElement* array, vtkIdType components, vtkIdType count)
  {
    if (this->exceeded.empty() && this->value(array, components * count))
    {
      this->exceeded = std::string(what) + ", " + std::to_string(count);
    }
  }
};

template <typename Reader>
std::string read(const std::string& file)
{
  vtkNew<WholeReader<Reader>> reader;
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  // Only points, their normals, and cells are wanted.
  reader->GetPointDataArraySelection()->DisableAllArrays();
  reader->SetPointArrayStatus("Normals", 1);
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
  if (!reader->exceeded.empty())
  {
    throw InputError("there are more " + reader->exceeded + "; correct it");
  }
  return bytesOf(reader->GetOutput());
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
  return surfaceOf(file, result.text);
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
