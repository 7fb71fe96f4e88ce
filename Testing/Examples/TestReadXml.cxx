// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"
#include "Messages.h"
#include "Pyramid.h"
#include "ReadXml.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <string>
#include <utility>
#include <vector>

using namespace pyramid;

namespace
{
/// VTK's errors are not printed: the readers look at them.
const bool isCaptured = (messages::capture(true), true);

/// The corners of all polygons.
std::vector<std::vector<vtkIdType>> polygonsOf(vtkPolyData* mesh)
{
  std::vector<std::vector<vtkIdType>> result;
  vtkNew<vtkIdList> polygon;
  mesh->GetPolys()->InitTraversal();
  while (mesh->GetPolys()->GetNextCell(polygon))
  {
    result.emplace_back(polygon->begin(), polygon->end());
  }
  return result;
}

TEST(ReadXml, TakeTheSurfaceCellsOfXmlFiles)
{
  const std::vector<std::vector<vtkIdType>> strip{ { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 } };
  // A vertex, a line, a pixel, a strip, a tetrahedron, a polygon of two corners.
  const auto grid = readVtu(write("kinds.vtu",
    vtu({ { 0 }, { 0, 1 }, { 0, 1, 3, 2 }, { 0, 1, 2, 3, 4 }, { 0, 1, 2, 4 }, { 0, 1 } },
      "1 3 8 6 10 7")));
  std::vector<std::vector<vtkIdType>> expected{ { 0, 1, 2, 3 } };
  expected.insert(expected.end(), strip.begin(), strip.end());
  EXPECT_EQ(polygonsOf(grid), expected);
  const auto surface = readVtp(write("strip.vtp",
    vtp("NumberOfStrips='1' NumberOfVerts='1'",
      "<Verts>" + cellArrays({ { 4 } }) + "</Verts><Strips>" + cellArrays({ { 0, 1, 2, 3, 4 } }) +
        "</Strips>")));
  EXPECT_EQ(polygonsOf(surface), strip);
}

TEST(ReadXml, RefuseXmlFilesWhoseCellsContradictThemselves)
{
  const auto refusal = [](const std::string& name, const std::string& content) -> std::string {
    try
    {
      (name == "p.vtp" ? readVtp : readVtu)(write(name, content));
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "read";
  };
  const auto replaced = [](std::string text, const std::string& old, const std::string& next) {
    return text.replace(text.find(old), old.size(), next);
  };
  for (const auto& [name, content] : { std::pair("p.vtp", vtp()), std::pair("p.vtu", vtu()) })
  {
    SCOPED_TRACE(name);
    EXPECT_EQ(refusal(name, content), "read");
    const auto expect = [&](const char* old, const char* next, const char* message) {
      const std::string text = refusal(name, replaced(content, old, next));
      EXPECT_NE(text.find(message), std::string::npos) << text;
    };
    expect("3 2 1 0 ", "3 2 1 5 ", "names point 5, but there are 5");
    expect("3 2 1 0 ", "3 2 1 -1 ", "names point -1");
    expect("4 7 10 13 16", "4 7 6 13 16", "offsets");
    expect("4 7 10 13 16", "4 7 10 13 15", "corners");
    expect("4 7 10 13 16", "4 7 10 13 99", "can't be read");
    expect("'5'>\n<Points>", "'4'>\n<Points>", "more cells than announced, 4");
    expect("'5'>\n<Points>", "'6'>\n<Points>", "can't be read");
  }
  EXPECT_NE(refusal("p.vtu", vtu({ { 0, 1, 2 }, { 2, 3, 4 } }, "5")), "read");
}

TEST(ReadXml, TakeNormals)
{
  const std::string points = "</Points>";
  std::string file = vtp();
  file.insert(file.find(points) + points.size(),
    "<PointData><DataArray type='Float32' Name='Normals' NumberOfComponents='3' format='ascii'>"
    "0 0 1 0 0 2 0 0 3 0 0 4 0 0 0</DataArray></PointData>");
  const auto mesh = readVtp(write("normals.vtp", file));
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  ASSERT_TRUE(normals);
  EXPECT_EQ(normals->GetNumberOfTuples(), 5);
  EXPECT_EQ(normals->GetComponent(3, 2), 4);
  EXPECT_FALSE(readVtp(write("plain.vtp", vtp()))->GetPointData()->GetNormals());
}
}
