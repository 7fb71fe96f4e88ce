// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"
#include "Lines.h"
#include "Messages.h"
#include "Pyramid.h"
#include "ReadObj.h"
#include "ReadPly.h"
#include "ReadStl.h"
#include "ReadText.h"
#include "ReadXml.h"
#include "Resolution.h"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace pyramid;

namespace
{
/// Twice the vector area of a polygon, times the height of the origin over it: six times the volume of the
/// cone.
double sixVolumes(vtkPolyData* mesh, vtkIdList* polygon)
{
  double sum = 0;
  for (vtkIdType i = 2; i < polygon->GetNumberOfIds(); ++i)
  {
    double a[3], b[3], c[3];
    mesh->GetPoint(polygon->GetId(0), a);
    mesh->GetPoint(polygon->GetId(i - 1), b);
    mesh->GetPoint(polygon->GetId(i), c);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

/// VTK's errors are not printed: the readers of XML files look at them.
const bool isCaptured = (messages::capture(true), true);

TEST(Readers, FindPointsAndPolygonsOfAPyramid)
{
  for (const Format& format : formats())
  {
    SCOPED_TRACE(format.name);
    const auto mesh = format.read(write(format.name, format.content));
    EXPECT_EQ(mesh->GetNumberOfPoints(), 5);
    EXPECT_EQ(mesh->GetPoints()->GetDataType(), format.type);
    EXPECT_EQ(mesh->GetNumberOfPolys(), format.read == readStl ? 6 : 5);
    double sum = 0;
    vtkNew<vtkIdList> polygon;
    mesh->GetPolys()->InitTraversal();
    while (mesh->GetPolys()->GetNextCell(polygon))
    {
      sum += sixVolumes(mesh, polygon);
    }
    EXPECT_NEAR(sum / 6, 1.0 / 3, 1e-12);
  }
}

/// Cuts the content, or replaces some of its bytes.
std::string damaged(std::string content, std::mt19937& random)
{
  const auto below = [&](std::size_t end) { return random() % end; };
  if (below(4) == 0)
  {
    return content.substr(0, below(content.size()));
  }
  const std::string digits = "0123456789-+.,e \n/\\";
  for (std::size_t i = 1 + below(4); i > 0; --i)
  {
    content[below(content.size())] =
      below(2) == 0 ? digits[below(digits.size())] : static_cast<char>(below(256));
  }
  return content;
}

TEST(Readers, ReadDamagedFilesAsTheyAreOrRefuseThem)
{
  std::mt19937 random(20);
  int refused = 0, read = 0;
  for (const Format& format : formats())
  {
    SCOPED_TRACE(format.name);
    for (int i = 0; i < 300; ++i)
    {
      const std::string file =
        write("damaged-" + std::string(format.name), damaged(format.content, random));
      try
      {
        const auto mesh = format.read(file);
        ++read;
        vtkNew<vtkIdList> polygon;
        mesh->GetPolys()->InitTraversal();
        while (mesh->GetPolys()->GetNextCell(polygon))
        {
          for (vtkIdType corner = 0; corner < polygon->GetNumberOfIds(); ++corner)
          {
            ASSERT_LT(polygon->GetId(corner), mesh->GetNumberOfPoints());
            ASSERT_GE(polygon->GetId(corner), 0);
          }
        }
      }
      catch (const InputError& error)
      {
        ++refused;
        ASSERT_EQ(std::string(error.what()).find(file), 0u) << error.what();
      }
    }
  }
  EXPECT_GT(refused, 700);
  EXPECT_GT(read, 100);
}

/// Is the file refused, by the reader or because there is no point in it?
bool isRefused(const Format& format, const std::string& file)
{
  try
  {
    return format.read(file)->GetNumberOfPoints() == 0;
  }
  catch (const InputError&)
  {
    return true;
  }
}

TEST(Readers, RefuseEveryCutFile)
{
  for (const Format& format : formats())
  {
    if (format.read == readObj)
    {
      continue; // it has no counts; a line is whole or not
    }
    // The last line of a text may lack its end, and a part of its last word, which is a number or a name.
    const std::size_t lastWord = format.content.find_last_of(" \n", format.content.size() - 2);
    const bool isText = format.content.find('\0') == std::string::npos;
    const std::size_t end = isText ? lastWord : format.content.size();
    const bool isApart = format.read == readVtp || format.read == readVtu; // takes longer
    for (std::size_t size = 0; size < end; size += isApart ? 29 : 1)
    {
      const std::string file = write("cut", format.content.substr(0, size));
      EXPECT_TRUE(isRefused(format, file)) << format.name << ", cut after " << size;
    }
  }
}

TEST(Lines, ReadWholeWordsAsNumbers)
{
  double value = 0;
  for (const auto& [word, expected] : std::vector<std::pair<std::string, double>>{ { "1", 1 },
         { "-0.5", -0.5 }, { "+2e3", 2000 }, { ".5", 0.5 }, { "5.", 5 },
         { "1e400", std::numeric_limits<double>::infinity() }, { "-1e-400", 0 } })
  {
    EXPECT_TRUE(parseReal(word, value)) << word;
    EXPECT_EQ(value, expected) << word;
  }
  EXPECT_TRUE(parseReal("nan", value) && std::isnan(value));
  EXPECT_TRUE(parseReal("-inf", value) && std::isinf(value));
  for (const char* word : { "", "+", "-", "+-1", "0x10", "1.2.3", "1,5", "zz", "1e", "--1" })
  {
    EXPECT_FALSE(parseReal(word, value)) << word;
  }
  long long number = 0;
  EXPECT_TRUE(parseWhole("0012", number));
  EXPECT_EQ(number, 12);
  for (const char* word : { "", "-1", "+1", "1.0", "1e3", "9999999999999999999" })
  {
    EXPECT_FALSE(parseWhole(word, number)) << word;
  }
}

TEST(Lines, CountLinesOfAllKinds)
{
  Lines lines("file",
    "\xEF\xBB\xBF"
    "a\r\nb\rc\n\n# no words\nd e",
    Lines::Columns);
  std::string words;
  while (lines.next())
  {
    words += std::to_string(lines.number()) + std::string(lines.words().back());
  }
  EXPECT_EQ(words, "1a2b3c6e");
}
}

TEST(Resolution, IsTheLastDigitOfTheLargestNumbers)
{
  const auto of = [](const std::vector<const char*>& words) {
    Resolution resolution;
    for (const char* word : words)
    {
      resolution.add(word);
    }
    return resolution.value();
  };
  EXPECT_DOUBLE_EQ(of({ "1.25", "-0.5", "1.125" }), 1e-3);
  EXPECT_DOUBLE_EQ(of({ "0.00012345", "-123.45", "12.345" }), 1e-2);
  EXPECT_DOUBLE_EQ(of({ "1.0", "0.12345" }), 1e-4);
  EXPECT_DOUBLE_EQ(of({ "1.5e2", "+2.25E+02" }), 1);
  EXPECT_DOUBLE_EQ(of({ "1.250e-3" }), 1e-6);
  EXPECT_DOUBLE_EQ(of({ "-.5" }), 1e-1);
  EXPECT_DOUBLE_EQ(of({ "5." }), 1);
  EXPECT_DOUBLE_EQ(of({ "3e4" }), 1e4);
  EXPECT_EQ(of({ "1", "12", "-7", "0", "0.000", "0e0", "nan", "inf" }), 0);
  EXPECT_EQ(of({}), 0);
}

TEST(Resolution, ComesWithTexts)
{
  for (const Format& format : formats())
  {
    SCOPED_TRACE(format.name);
    const vtkSmartPointer<vtkPolyData> mesh = format.read(write(format.name, format.content));
    vtkDataArray* unit = mesh->GetFieldData()->GetArray("SampleResolution");
    const std::string name = format.name;
    const bool isText =
      name == "pyramid.obj" || name == "pyramid.off" || name == "ascii.stl" || name == "ascii.ply";
    ASSERT_EQ(unit != nullptr, isText);
    EXPECT_DOUBLE_EQ(unit ? unit->GetComponent(0, 0) : 1e-6, 1e-6); // as std::to_string writes
  }
}

/// The z of all normals of a text, or nothing where it has none.
std::vector<double> normalHeights(const std::string& name, const std::string& content, Read read)
{
  vtkDataArray* normals = nullptr;
  const auto mesh = read(write(name, content));
  normals = mesh->GetPointData()->GetNormals();
  std::vector<double> result;
  for (vtkIdType i = 0; normals && i < normals->GetNumberOfTuples(); ++i)
  {
    result.push_back(normals->GetComponent(i, 2));
  }
  return result;
}

TEST(Readers, FindNormals)
{
  using Heights = std::vector<double>;
  const Heights both = { 0.8, -0.5 };
  const auto text = [](const std::string& content) {
    return normalHeights("normals.xyz", content, readXyz);
  };
  EXPECT_EQ(text("x y z nx ny nz\n1 2 3 0.6 0 0.8\n1 2 4 0 0 -0.5\n"), both);
  EXPECT_EQ(text("//X,Y,Z,R,Nx,Ny,Nz\n1,2,3,9,0.6,0,0.8\n1,2,4,9,0,0,-0.5\n"), both);
  EXPECT_EQ(text("1 2 3 0.6 0 0.8\n1 2 4 0 0 -1\n"), Heights({ 0.8, -1 }));
  EXPECT_EQ(text("1 2 3 0.6 0 0.8\n1 2 4 0 0 -0.5\n"), Heights()); // colours
  EXPECT_EQ(text("x y z r g b\n1 2 3 0.6 0 0.8\n"), Heights());
  EXPECT_EQ(text("x y z nx ny nz\n1 2 3 0.6 0 0.8\n1 2 4\n"), Heights());
  EXPECT_EQ(text("1 2 3\n1 2 4\n"), Heights());
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty "
                             "float nz\nproperty float y\nproperty float z\nproperty float nx\n";
  EXPECT_EQ(normalHeights("normals.ply",
              header + "property float ny\nend_header\n1 0.8 2 3 0.6 0\n1 -0.5 2 4 0 0\n", readPly),
    both);
  EXPECT_EQ(normalHeights("normals.ply",
              header + "property float q\nend_header\n1 0.8 2 3 0.6 0\n1 -0.5 2 4 0 0\n", readPly),
    Heights());
}
