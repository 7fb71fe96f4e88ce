// SPDX-License-Identifier: BSD-3-Clause
#include "MedialMeshTest.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkPointData.h>

#include <sstream>

namespace
{
using filterTest::onlyError;
using medialMeshTest::Cells;
using medialMeshTest::cellsOf;
using medialMeshTest::File;
using medialMeshTest::meshOf;

/// Two triangles, an edge at one of their points, and a point of its own.
const std::string plain =
  "6 6 2\n"
  "v 0 0 0 0.5\nv 1 0 0 0.25\nv 0 1 0 0.125\nv 1 1 0 1\nv 2 2 0 2\nv 9 9 9 3\n"
  "e 0 1\ne 1 2\ne 2 0\ne 1 3\ne 3 2\ne 3 4\n"
  "f 0 1 2\nf 1 3 2\n";

/// The same with a text in the place of another one.
std::string changed(const std::string& from, const std::string& to)
{
  std::string text = plain;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::vector<double> values(vtkDataArray* array)
{
  std::vector<double> result;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    result.push_back(array->GetComponent(i, 0));
  }
  return result;
}

std::vector<double> typesOf(vtkFieldData* data)
{
  return values(data->GetArray("Type"));
}

void expectPlain(vtkPolyData* mesh)
{
  ASSERT_EQ(mesh->GetNumberOfPoints(), 6);
  EXPECT_EQ(medial::Point(mesh->GetPoint(4)), medial::Point(2, 2, 0));
  EXPECT_EQ(values(mesh->GetPointData()->GetArray("Radius")),
    std::vector<double>({ 0.5, 0.25, 0.125, 1, 2, 3 }));
  EXPECT_EQ(cellsOf(mesh->GetVerts()), Cells({ { 5 } }));
  EXPECT_EQ(cellsOf(mesh->GetLines()), Cells({ { 3, 4 } }));
  EXPECT_EQ(cellsOf(mesh->GetPolys()), Cells({ { 0, 1, 2 }, { 1, 3, 2 } }));
}

/// The error of reading a file with this text.
std::string errorOf(const std::string& text)
{
  const File file(text);
  vtkNew<vtkMedialMeshReader> reader;
  reader->SetFileName(file.name());
  const std::string error = onlyError(reader);
  EXPECT_NE(error.find(file.name()), std::string::npos) << error;
  return error;
}

void expectError(const std::string& text, const std::vector<std::string>& fragments)
{
  const std::string error = errorOf(text);
  for (const std::string& fragment : fragments)
  {
    EXPECT_NE(error.find(fragment), std::string::npos) << fragment << " isn't in: " << error;
  }
}

TEST(MedialMeshReader, MakesNoLinesOfSidesAndVerticesOfPointsAlone)
{
  expectPlain(meshOf(plain));
  EXPECT_FALSE(meshOf(plain)->GetPointData()->HasArray("Type"));
  EXPECT_FALSE(meshOf(plain)->GetCellData()->HasArray("Type"));
}

TEST(MedialMeshReader, SkipsBlankLinesAndCommentsAndTakesAnyEndOfLineAndOrder)
{
  expectPlain(
    meshOf("# made by a test\n\n" + changed("e 0 1\n", " \t\n#e 9 9\ne\t0  1 # first\n\n")));
  expectPlain(meshOf("\xEF\xBB\xBF" + plain));
  for (const char* end : { "\r\n", "\r" })
  {
    std::string text = plain;
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    {
      text.replace(at, 1, end);
    }
    expectPlain(meshOf(text));
  }
  const std::size_t edges = plain.find("e 0 1"), points = plain.find("v 0 0");
  expectPlain(
    meshOf(plain.substr(0, points) + plain.substr(edges) + plain.substr(points, edges - points)));
  expectPlain(meshOf(plain.substr(0, plain.size() - 1))); // without a line feed at the end
}

TEST(MedialMeshReader, ReadsNumbersToTheLastBit)
{
  const auto mesh = meshOf("2 1 0\nv 0.1 -1e-320 +1.7976931348623157e308 4.9e-324\n"
                           "v -0.30000000000000004 1e-400 3. 1E2\ne 0 1\n");
  EXPECT_EQ(mesh->GetPoint(0)[0], 0.1);
  EXPECT_EQ(mesh->GetPoint(0)[1], -1e-320);
  EXPECT_EQ(mesh->GetPoint(0)[2], 1.7976931348623157e308);
  EXPECT_EQ(mesh->GetPoint(1)[0], -0.30000000000000004);
  EXPECT_EQ(mesh->GetPoint(1)[1], 0);
  EXPECT_EQ(mesh->GetPoint(1)[2], 3);
  EXPECT_EQ(
    values(mesh->GetPointData()->GetArray("Radius")), std::vector<double>({ 4.9e-324, 100 }));
}

/// As MATTopo writes them: sides with a type are features.
TEST(MedialMeshReader, KeepsTypesAndSidesThatHaveOne)
{
  const auto mesh =
    meshOf("5 5 1\nv 0 0 0 1 2\nv 1 0 0 1 3\nv 0 1 0 1 -1\nv 1 1 0 1 4\nv 5 5 5 1 10\n"
           "e 0 1 2\ne 1 2 0\ne 0 2 1\ne 1 3 0\ne 2 3 2\nf 0 1 2\n");
  EXPECT_EQ(cellsOf(mesh->GetLines()), Cells({ { 0, 1 }, { 0, 2 }, { 1, 3 }, { 2, 3 } }));
  EXPECT_EQ(typesOf(mesh->GetPointData()), std::vector<double>({ 2, 3, -1, 4, 10 }));
  EXPECT_EQ(typesOf(mesh->GetCellData()), std::vector<double>({ -1, 2, 1, 0, 2, -1 }));
  EXPECT_FALSE(meshOf("1 0 0\nv 0 0 0 1 2\n")->GetCellData()->HasArray("Type"));
}

/// The point 1 is deleted, and so are an edge, a triangle and a tetrahedron.
const std::string copies = "6 4 2 2\n"
                           "v 0 0 0 1 2 0 1\nv 7 7 7 7 2 1 1\nv 1 0 0 1 3 0 2\nv 0 1 0 1 4 0 1\n"
                           "v 0 0 1 1 2 0 1\nv 3 3 3 1 2 0 1\n"
                           "e 0 2 2 0 1\ne 2 3 0 0 1\ne 0 1 0 1 1\ne 4 5 1 0 3\n"
                           "f 0 2 3 0.25 0 1\nf 0 2 4 1e-3 1 1\n"
                           "t 0 2 3 4 0 1\nt 0 2 3 5 1 1\n";

TEST(MedialMeshReader, LeavesDeletedCellsPointsAndTetrahedraOut)
{
  const auto mesh = meshOf(copies);
  ASSERT_EQ(mesh->GetNumberOfPoints(), 5);
  EXPECT_EQ(medial::Point(mesh->GetPoint(1)), medial::Point(1, 0, 0));
  EXPECT_EQ(cellsOf(mesh->GetPolys()), Cells({ { 0, 1, 2 } }));
  EXPECT_EQ(cellsOf(mesh->GetLines()), Cells({ { 0, 1 }, { 3, 4 } }));
  EXPECT_EQ(mesh->GetNumberOfVerts(), 0);
  EXPECT_EQ(typesOf(mesh->GetPointData()), std::vector<double>({ 2, 3, 4, 2, 2 }));
  EXPECT_EQ(typesOf(mesh->GetCellData()), std::vector<double>({ 2, 1, -1 }));
  // without what follows the indices
  EXPECT_EQ(
    meshOf("4 1 1 1\nv 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nv 0 0 1 1\ne 0 3\nf 0 1 2\nt 0 1 2 3\n")
      ->GetNumberOfCells(),
    2);
  // a deleted point that a living edge needs
  EXPECT_EQ(
    meshOf("2 1 0 0\nv 0 0 0 1 2 1 1\nv 1 0 0 1 2 0 1\ne 0 1 0 0 1\n")->GetNumberOfPoints(), 2);
}

TEST(MedialMeshReader, WarnsOfTetrahedraAndOfWhatComesAgain)
{
  const std::string again =
    changed("e 3 4\nf 0 1 2\nf 1 3 2\n", "e 3 4\ne 4 3\nf 0 1 2\nf 1 3 2\nf 2 0 1\n");
  for (const auto& [text, fragment] : { std::pair(copies, "and triangles: 1"),
         std::pair("6 7 3" + again.substr(5), "taken once; left out: 2") })
  {
    const File file(text);
    vtkNew<vtkMedialMeshReader> reader;
    reader->SetFileName(file.name());
    const filterTest::ErrorLog log(reader, vtkCommand::WarningEvent);
    reader->Update();
    ASSERT_EQ(log.messages().size(), 1u);
    EXPECT_NE(log.messages()[0].find(fragment), std::string::npos) << log.messages()[0];
    if (text != copies)
    {
      expectPlain(reader->GetOutput());
    }
  }
}

/// As early versions of Coverage Axis write them.
TEST(MedialMeshReader, TakesIndicesFromOneWhereOnlyThatFits)
{
  const auto fromOne = [](const std::string& lonely) {
    return "5 4 1\nv 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nv 1 1 1 1\nv 2 2 2 1\n"
           "e 1 2\ne 2 3\ne 1 3\ne " +
      lonely + "\nf 1 2 3\n";
  };
  const auto mesh = meshOf(fromOne("3 5"));
  EXPECT_EQ(cellsOf(mesh->GetPolys()), Cells({ { 0, 1, 2 } }));
  EXPECT_EQ(cellsOf(mesh->GetLines()), Cells({ { 2, 4 } }));
  EXPECT_EQ(cellsOf(mesh->GetVerts()), Cells({ { 3 } }));
  expectError(fromOne("0 5"), { "line 10: there is no point 5", "counted from 0" });
  expectError(fromOne("3 6"), { "line 10: there is no point 6" });
  // where the last point is in no cell, nothing tells
  EXPECT_EQ(cellsOf(meshOf(fromOne("3 4"))->GetPolys()), Cells({ { 1, 2, 3 } }));
}

TEST(MedialMeshReader, ReadsPointsAloneAndNothing)
{
  EXPECT_EQ(meshOf("2 0 0\nv 0 0 0 1\nv 1 1 1 1\n")->GetNumberOfVerts(), 2);
  EXPECT_EQ(meshOf("0 0 0\n")->GetNumberOfCells(), 0);
}

TEST(MedialMeshReader, RefusesWrongFirstLines)
{
  expectError("", { "line 1: the file is empty", "write the file again" });
  expectError("# nothing else\n\n", { "the file is empty" });
  for (const char* first : { "6 6", "6 6 2 0 0", "six 6 2", "6 6 -2", "6.0 6 2",
         "6 6 99999999999999999999999", "OFF", "PK\x03\x04" })
  {
    expectError(changed("6 6 2", first),
      { "line 1: expected the numbers of points, edges and triangles of a medial mesh, found" });
  }
  expectError("\n//Maya ASCII 2023 scene\nrequires maya;\n", { "line 2: this is a scene of Maya" });
}

TEST(MedialMeshReader, RefusesWrongLinesAndTellsWhich)
{
  struct Case
  {
    std::string from, to;
    std::vector<std::string> fragments;
  };
  const std::vector<Case> cases = {
    { "v 1 0 0 0.25", "v 1 0 0", { "line 3: expected v x y z r", "found 'v 1 0 0'" } },
    { "v 1 0 0 0.25", "v 1 0 0 0.25 1 0", { "line 3: expected v x y z r" } },
    { "v 1 0 0 0.25", "v 1 0 0 0.25 1.5", { "line 3: expected v x y z r" } },
    { "v 1 0 0 0.25", "v 1 0 0 0,25", { "line 3: expected v x y z r" } },
    { "v 1 0 0 0.25", "v 1 0 x 0.25", { "line 3: expected v x y z r" } },
    { "v 1 0 0 0.25", "v nan 0 0 0.25", { "line 3: expected finite" } },
    { "v 1 0 0 0.25", "v 1 0 inf 0.25", { "line 3: expected finite" } },
    { "v 1 0 0 0.25", "v 1 0 1e999 0.25", { "line 3: expected v x y z r" } },
    { "v 1 0 0 0.25", "v 1 0 0 -0.25", { "line 3: expected finite", "radius of at least 0" } },
    { "v 1 0 0 0.25", "w 1 0 0 0.25", { "line 3: expected a line that begins with v, e or f" } },
    { "v 1 0 0 0.25", "vv 1 0 0 0.25", { "line 3: expected a line that begins with v, e or f" } },
    { "e 1 2", "e 1", { "line 9: expected e i j" } },
    { "e 1 2", "e 1 2 0 1", { "line 9: there are two numbers", "deleted", "write e i j type" } },
    { "e 1 2", "e 1 2 0 1 1", { "line 9: expected e i j" } },
    { "e 1 2", "e 1 2 x", { "line 9: expected e i j" } },
    { "e 1 2", "e 1 -2", { "line 9: expected e i j" } },
    { "e 1 2", "e 1 2.0", { "line 9: expected e i j" } },
    { "e 1 2", "e 1 99999999999", { "line 9: expected e i j" } },
    { "e 1 2", "e 1 2147483647", { "line 9: expected e i j" } },
    { "e 1 2", "e 1 2147483646", { "line 9: there is no point 2147483646" } },
    { "e 1 2", "e 1 6", { "line 9: there is no point 6", "6 points are counted from 0" } },
    { "e 1 2", "e 2 2", { "line 9: the point 2 is there twice", "delete" } },
    { "e 1 2\n", "",
      { "line 14: the file ends after 5 of 6 lines that begin with e", "it was cut" } },
    { "f 1 3 2", "f 1 3", { "line 15: expected f i j k" } },
    { "f 1 3 2", "f 1 3 2 0", { "line 15: expected f i j k" } },
    { "f 1 3 2", "f 1 3 7", { "line 15: there is no point 7" } },
    { "f 1 3 2", "f 1 3 1", { "line 15: the point 1 is there twice" } },
    { "f 1 3 2", "f 1 3 2\nf 0 1 3",
      { "line 16: there are more lines that begin with f than the 2" } },
    { "f 1 3 2", "f 1 3 2\n3\n", { "line 16: expected a line that begins with v, e or f" } },
    { "f 1 3 2", "t 0 1 2 3", { "line 15: expected a line that begins with v, e or f" } },
    { "6 6 2", "18446744073709551615 6 2",
      { "the file ends after 6 of 18446744073709551615 lines" } },
    { "6 6 2", "6 6 3000000000", { "the file ends after 2 of 3000000000 lines" } },
  };
  for (const Case& test : cases)
  {
    SCOPED_TRACE(test.from + " -> " + test.to);
    expectError(changed(test.from, test.to), test.fragments);
  }
}

TEST(MedialMeshReader, RefusesWrongLinesOfFilesWithCopies)
{
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = copies;
    return text.replace(text.find(from), from.size(), to);
  };
  expectError(with("v 1 0 0 1 3 0 2", "v 1 0 0 1 3 2 2"), { "line 4: expected v x y z r" });
  expectError(with("v 1 0 0 1 3 0 2", "v 1 0 0 1 3 0"), { "line 4: expected v x y z r" });
  expectError(with("e 2 3 0 0 1", "e 2 3 0 0"), { "line 9: expected e i j" });
  expectError(with("e 2 3 0 0 1", "e 2 3 0 x 1"), { "line 9: expected e i j" });
  expectError(with("f 0 2 3 0.25 0 1", "f 0 2 3 0.25"), { "line 12: expected f i j k" });
  expectError(with("t 0 2 3 4 0 1", "t 0 2 3"), { "line 14: expected t i j k l" });
  expectError(with("t 0 2 3 4 0 1", "t 0 2 3 6 0 1"), { "line 14: there is no point 6" });
  expectError(with("t 0 2 3 4 0 1", "t 0 2 3 3 0 1"), { "line 14: the point 3 is there twice" });
  expectError(
    with("t 0 2 3 4 0 1", "x"), { "line 14: expected a line that begins with v, e, f or t" });
}

/// Cut at each byte but the last ones it can't be whole; nothing may crash.
TEST(MedialMeshReader, RefusesCutFiles)
{
  for (const std::string& text : { plain, copies })
  {
    const std::size_t last = text.rfind('\n', text.size() - 2);
    for (std::size_t size = 0; size <= last; ++size)
    {
      SCOPED_TRACE(size);
      expectError(text.substr(0, size), { "line " });
    }
  }
}

TEST(MedialMeshReader, SurvivesNonsense)
{
  expectError(std::string(100000, 'v'), { "line 1: expected the numbers" });
  expectError(std::string(1000, '\0'), { "line 1: expected the numbers" });
  expectError(
    "1 0 0\nv" + std::string(1000000, ' ') + std::string(1000000, '1'), { "line 2: expected v" });
  std::string numbers = "1 0 0\nv";
  for (int i = 0; i < 100000; ++i)
  {
    numbers += " 1";
  }
  expectError(numbers, { "line 2: expected v x y z r" });
  unsigned seed = 7;
  for (int turn = 0; turn < 2000; ++turn)
  {
    std::string text = plain;
    for (int change = 0; change < 3; ++change)
    {
      seed = seed * 1664525u + 1013904223u;
      text[(seed >> 8) % text.size()] = "0123456789 vef.-\n#\xFF"[(seed >> 24) % 19];
    }
    SCOPED_TRACE("seed 7, turn " + std::to_string(turn));
    const File file(text);
    vtkNew<vtkMedialMeshReader> reader;
    reader->SetFileName(file.name());
    const filterTest::ErrorLog log(reader);
    reader->Update();
    const bool isRead = reader->GetErrorCode() == vtkErrorCode::NoError;
    EXPECT_EQ(log.messages().size(), isRead ? 0u : 1u);
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints() > 0, isRead);
  }
}

TEST(MedialMeshReader, RefusesFilesThatCannotBeRead)
{
  vtkNew<vtkMedialMeshReader> reader;
  EXPECT_NE(onlyError(reader).find("set FileName"), std::string::npos);
  reader->SetFileName("/nowhere/axis.ma");
  std::string error = onlyError(reader);
  EXPECT_NE(error.find("/nowhere/axis.ma: can't be read: No such file"), std::string::npos)
    << error;
  reader->SetFileName(testing::TempDir().c_str());
  error = onlyError(reader);
  EXPECT_NE(error.find("can't be read: Is a directory"), std::string::npos) << error;
  const File file(plain);
  reader->SetFileName(file.name());
  reader->Update();
  expectPlain(reader->GetOutput());
}

TEST(MedialMeshReader, CanBeStoppedAndReadsAgainThen)
{
  const File file(plain);
  vtkNew<vtkMedialMeshReader> reader;
  reader->SetFileName(file.name());
  reader->SetAbortExecute(1);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);
  int reports = 0;
  filterTest::countEvents(reader, vtkCommand::ProgressEvent, reports);
  reader->Update();
  expectPlain(reader->GetOutput());
  EXPECT_GT(reports, 2);
}

TEST(MedialMeshReader, PrintsItself)
{
  std::ostringstream text;
  vtkNew<vtkMedialMeshReader> reader;
  reader->SetFileName("axis.ma");
  reader->Print(text);
  EXPECT_NE(text.str().find("\n  FileName: axis.ma\n"), std::string::npos);
}
}
