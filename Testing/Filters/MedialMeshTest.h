// SPDX-License-Identifier: BSD-3-Clause
#ifndef MedialMeshTest_h
#define MedialMeshTest_h

#include "FilterTest.h"

#include "vtkMedialMeshReader.h"
#include "vtkMedialMeshWriter.h"

#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

/// What the tests of the reader and the writer of medial meshes share.
namespace medialMeshTest
{
/// A file that goes with this object.
class File
{
public:
  explicit File(const std::string& text = "")
    : Name(testing::TempDir() + "medialmesh-" + std::to_string(getpid()) + ".ma")
  {
    std::ofstream(this->Name, std::ios::binary) << text;
  }
  ~File() { std::remove(this->Name.c_str()); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  const char* name() const { return this->Name.c_str(); }

private:
  std::string Name;
};

/// The mesh of a file with this text, read without an error.
inline vtkSmartPointer<vtkPolyData> meshOf(const std::string& text)
{
  const File file(text);
  vtkNew<vtkMedialMeshReader> reader;
  reader->SetFileName(file.name());
  const filterTest::ErrorLog log(reader);
  reader->Update();
  EXPECT_TRUE(log.messages().empty()) << testing::PrintToString(log.messages());
  return reader->GetOutput();
}

/// The text that is written of a mesh, without an error.
inline std::string textOf(vtkPolyData* mesh)
{
  vtkNew<vtkMedialMeshWriter> writer;
  writer->SetInputData(mesh);
  writer->WriteToOutputStringOn();
  EXPECT_EQ(writer->Write(), 1);
  return writer->GetOutputString();
}

using Cells = std::vector<std::vector<vtkIdType>>;

inline Cells cellsOf(vtkCellArray* cells)
{
  Cells result;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(i, size, points);
    result.emplace_back(points, points + size);
  }
  return result;
}
}

#endif
