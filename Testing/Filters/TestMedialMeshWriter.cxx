// SPDX-License-Identifier: BSD-3-Clause
#include "MedialMeshTest.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <iterator>
#include <limits>
#include <sstream>
#include <sys/resource.h>

namespace
{
using filterTest::boxPipeline;
using filterTest::same;
using medialMeshTest::cellsOf;
using medialMeshTest::File;
using medialMeshTest::meshOf;
using medialMeshTest::textOf;

/// Points at random places, one of them unused, a triangle, a line and a vertex.
vtkSmartPointer<vtkPolyData> smallMesh()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  for (int i = 0; i < 7; ++i)
  {
    points->InsertNextPoint(std::sin(i), 1e-7 * std::cos(5 * i), -1e5 * std::sqrt(i));
    radii->InsertNextValue(std::exp(i) / 3);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->GetPointData()->AddArray(radii);
  vtkNew<vtkCellArray> vertices, lines, triangles;
  vertices->InsertNextCell({ 6 });
  lines->InsertNextCell({ 4, 3 });
  triangles->InsertNextCell({ 5, 3, 1 });
  triangles->InsertNextCell({ 3, 1, 0 });
  mesh->SetVerts(vertices);
  mesh->SetLines(lines);
  mesh->SetPolys(triangles);
  return mesh;
}

/// The message of the one error of a writer, which writes nothing.
std::string errorOf(vtkPolyData* mesh)
{
  vtkNew<vtkMedialMeshWriter> writer;
  writer->SetInputData(mesh);
  writer->WriteToOutputStringOn();
  const filterTest::ErrorLog log(writer);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(writer->GetOutputString(), "");
  EXPECT_EQ(log.messages().size(), 1u);
  return log.messages().empty() ? "" : log.messages()[0];
}

void expectError(vtkPolyData* mesh, const std::string& fragment)
{
  const std::string error = errorOf(mesh);
  EXPECT_NE(error.find(fragment), std::string::npos) << error;
}

/// Do two meshes have the same cells, with the same places and radii at their corners?
void expectSameCells(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  vtkDataArray *r = a->GetPointData()->GetArray("Radius"),
               *s = b->GetPointData()->GetArray("Radius");
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell)
  {
    vtkIdType sizeA = 0, sizeB = 0;
    const vtkIdType *cornersA = nullptr, *cornersB = nullptr;
    a->GetCellPoints(cell, sizeA, cornersA);
    b->GetCellPoints(cell, sizeB, cornersB);
    ASSERT_EQ(sizeA, sizeB);
    for (vtkIdType k = 0; k < sizeA; ++k)
    {
      ASSERT_EQ(medial::Point(a->GetPoint(cornersA[k])), medial::Point(b->GetPoint(cornersB[k])));
      ASSERT_EQ(r->GetComponent(cornersA[k], 0), s->GetComponent(cornersB[k], 0));
    }
  }
}

TEST(MedialMeshWriter, ListsUsedPointsThenAllEdgesThenTriangles)
{
  const std::string text = textOf(smallMesh());
  std::istringstream words(text);
  int points = 0, edges = 0, triangles = 0;
  words >> points >> edges >> triangles;
  EXPECT_EQ(points, 6); // point 2 is left out
  EXPECT_EQ(edges, 6);  // the line, five sides
  EXPECT_EQ(triangles, 2);
  EXPECT_EQ(text.substr(text.find("\ne ") + 1),
    "e 3 2\ne 4 2\ne 2 1\ne 1 4\ne 1 0\ne 0 2\nf 4 2 1\nf 2 1 0\n");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 6 + 6 + 2);
  EXPECT_NE(text.find("\nv 0 1e-07 -0 0.3333333333333333\n"), std::string::npos) << text;
}

TEST(MedialMeshWriter, IsReadBackToTheLastBit)
{
  const auto mesh = smallMesh();
  const auto back = meshOf(textOf(mesh));
  EXPECT_EQ(back->GetNumberOfPoints(), 6);
  expectSameCells(mesh, back);
  EXPECT_TRUE(same(back, meshOf(textOf(back))));
  EXPECT_EQ(textOf(back), textOf(mesh));
}

/// Whole, pruned to its skeleton, and of vertices alone.
TEST(MedialMeshWriter, KeepsAnAxis)
{
  vtkPolyData* axis = boxPipeline().axis->GetOutput();
  const auto back = meshOf(textOf(axis));
  expectSameCells(axis, back);
  EXPECT_GT(back->GetNumberOfPolys(), 100);
  vtkNew<vtkMedialPrune> prune;
  prune->SetInputData(axis);
  prune->SetSchedule("skeleton");
  prune->Update();
  expectSameCells(prune->GetOutput(), meshOf(textOf(prune->GetOutput())));
  EXPECT_LT(meshOf(textOf(prune->GetOutput()))->GetNumberOfPoints(), back->GetNumberOfPoints());
  const auto vertices = filterTest::copy<vtkPolyData>(axis);
  vertices->SetLines(nullptr);
  vertices->SetPolys(nullptr);
  vertices->SetVerts(nullptr);
  vertices->GetCellData()->Initialize();
  EXPECT_EQ(textOf(vertices), "0 0 0\n");
  vtkNew<vtkCellArray> lonely;
  lonely->InsertNextCell({ 3 });
  lonely->InsertNextCell({ 8 });
  vertices->SetVerts(lonely);
  expectSameCells(vertices, meshOf(textOf(vertices)));
}

TEST(MedialMeshWriter, WritesRandomNumbersSoThatTheyAreReadBack)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  vtkNew<vtkCellArray> lines;
  std::uint64_t seed = 11;
  const auto next = [&seed] {
    double value = std::nan("");
    while (!std::isfinite(value))
    {
      seed = seed * 6364136223846793005u + 1442695040888963407u;
      const std::uint64_t bits = seed ^ (seed >> 29);
      std::copy_n(
        reinterpret_cast<const char*>(&bits), sizeof(value), reinterpret_cast<char*>(&value));
    }
    return value;
  };
  for (vtkIdType i = 0; i < 20000; ++i)
  {
    points->InsertNextPoint(next(), next(), next());
    radii->InsertNextValue(std::abs(next()));
    if (i > 0)
    {
      lines->InsertNextCell({ i - 1, i });
    }
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetLines(lines);
  mesh->GetPointData()->AddArray(radii);
  SCOPED_TRACE("seed 11");
  EXPECT_TRUE(same(mesh, meshOf(textOf(mesh))));
}

TEST(MedialMeshWriter, TakesRadiiAndPointsOfFloats)
{
  const auto mesh = smallMesh();
  vtkNew<vtkFloatArray> radii;
  radii->DeepCopy(mesh->GetPointData()->GetArray("Radius"));
  radii->SetName("Radius");
  mesh->GetPointData()->AddArray(radii);
  expectSameCells(mesh, meshOf(textOf(mesh)));
}

TEST(MedialMeshWriter, WritesTypesBack)
{
  const std::string typed =
    "5 6 1\nv 0 0 0 1 2\nv 1 0 0 1 3\nv 0 1 0 1 -1\nv 1 1 0 1 4\nv 5 5 5 1 10\n"
    "e 0 1 2\ne 0 2 1\ne 1 3 0\ne 2 3 2\ne 3 0 0\ne 1 2 0\nf 0 1 2\n";
  EXPECT_EQ(textOf(meshOf(typed)), typed);
  const std::string points = "2 1 0\nv 0 0 0 1 2\nv 1 0 0 1 3\ne 1 0\n";
  EXPECT_EQ(textOf(meshOf(points)), points);
}

TEST(MedialMeshWriter, RefusesOtherCellsRadiiAndNumbers)
{
  auto mesh = smallMesh();
  mesh->GetPolys()->InsertNextCell({ 0, 1, 3, 4 });
  expectError(
    mesh, "4 corners instead of 3: give vertices, lines and triangles, as vtkTriangleFilter makes");
  mesh = smallMesh();
  mesh->GetLines()->InsertNextCell({ 0, 1, 3 });
  expectError(mesh, "3 corners instead of 2");
  mesh = smallMesh();
  mesh->GetVerts()->InsertNextCell({ 0, 1 });
  expectError(mesh, "2 corners instead of 1");
  mesh = smallMesh();
  mesh->GetLines()->InsertNextCell({ 0, 7 });
  expectError(mesh, "the corner 7 but there are 7 points");
  mesh = smallMesh();
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 3, 4 });
  mesh->SetStrips(strips);
  expectError(mesh, "triangle strips");
  mesh = smallMesh();
  mesh->GetPointData()->RemoveArray("Radius");
  expectError(mesh, "there is no point array 'Radius'");
  mesh = smallMesh();
  mesh->GetPointData()->GetArray("Radius")->SetComponent(2, 0, -1);
  expectError(mesh, "the value -1 at 2");
  mesh = smallMesh();
  mesh->GetPoints()->SetPoint(1, 0, std::numeric_limits<double>::infinity(), 0);
  expectError(mesh, "point 1 has a coordinate that is not finite");
  mesh = smallMesh();
  vtkNew<vtkIntArray> types;
  types->SetName("Type");
  types->SetNumberOfValues(3);
  types->FillValue(0);
  mesh->GetCellData()->AddArray(types);
  expectError(mesh, "'Type' has 3 entries instead of 4");
}

TEST(MedialMeshWriter, WritesAFileInThePlaceOfAnOlderOne)
{
  const File file("older");
  vtkNew<vtkMedialMeshWriter> writer;
  writer->SetInputConnection(boxPipeline().axis->GetOutputPort());
  writer->SetFileName(file.name());
  int reports = 0;
  filterTest::countEvents(writer, vtkCommand::ProgressEvent, reports);
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_GT(reports, 2);
  std::ifstream stream(file.name());
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_EQ(text, textOf(boxPipeline().axis->GetOutput()));
}

TEST(MedialMeshWriter, TellsOfFilesThatCannotBeWritten)
{
  vtkNew<vtkMedialMeshWriter> writer;
  writer->SetInputData(smallMesh());
  const filterTest::ErrorLog log(writer);
  EXPECT_EQ(writer->Write(), 0);
  writer->SetFileName("/nowhere/axis.ma");
  EXPECT_EQ(writer->Write(), 0);
  writer->SetFileName("/dev/full");
  EXPECT_EQ(writer->Write(), 0);
  ASSERT_EQ(log.messages().size(), 3u);
  EXPECT_TRUE(std::ifstream("/dev/full").is_open()) << "a device was removed";
  EXPECT_NE(log.messages()[0].find("set FileName"), std::string::npos) << log.messages()[0];
  EXPECT_NE(
    log.messages()[1].find("/nowhere/axis.ma: can't be written: No such file"), std::string::npos)
    << log.messages()[1];
  EXPECT_NE(log.messages()[2].find("/dev/full: can't be written: No space left"), std::string::npos)
    << log.messages()[2];
}

TEST(MedialMeshWriter, LeavesNoPartOfAFile)
{
  const File file("older");
  vtkNew<vtkMedialMeshWriter> writer;
  writer->SetInputData(boxPipeline().axis->GetOutput());
  writer->SetFileName(file.name());
  const filterTest::ErrorLog log(writer);
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = {};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small = { 1000, limit.rlim_max };
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_EQ(writer->Write(), 0);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, before);
  ASSERT_EQ(log.messages().size(), 1u);
  EXPECT_NE(log.messages()[0].find("can't be written: File too large"), std::string::npos)
    << log.messages()[0];
  EXPECT_FALSE(std::ifstream(file.name()).is_open());
}

TEST(MedialMeshWriter, WritesNothingWhenStopped)
{
  const File file("older");
  vtkNew<vtkMedialMeshWriter> writer;
  writer->SetInputConnection(boxPipeline().axis->GetOutputPort());
  writer->SetFileName(file.name());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* sender, unsigned long, void*, void*) {
    static_cast<vtkAlgorithm*>(sender)->SetAbortExecute(1);
  });
  const unsigned long observer = writer->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(writer->Write(), 0);
  std::ifstream stream(file.name());
  EXPECT_EQ(std::string((std::istreambuf_iterator<char>(stream)), {}), "older");
  writer->RemoveObserver(observer);
  EXPECT_EQ(writer->Write(), 1);
}

TEST(MedialMeshWriter, PrintsItself)
{
  std::ostringstream text;
  vtkNew<vtkMedialMeshWriter> writer;
  writer->Print(text);
  EXPECT_NE(
    text.str().find("\n  FileName: (none)\n  WriteToOutputString: off\n"), std::string::npos);
}
}
