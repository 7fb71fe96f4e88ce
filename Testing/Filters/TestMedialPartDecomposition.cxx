// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
using filterTest::arrays;
using filterTest::boxPipeline;
using filterTest::onlyError;

vtkTable* partTable()
{
  return vtkTable::SafeDownCast(boxPipeline().parts->GetOutputDataObject(1));
}

double cell(const char* array, vtkIdType number)
{
  return boxPipeline().parts->GetOutput()->GetCellData()->GetArray(array)->GetComponent(number, 0);
}

double column(const char* name, double part)
{
  return partTable()->GetValueByName(static_cast<vtkIdType>(part), name).ToDouble();
}

TEST(MedialPartDecomposition, AddsTheArraysOfItsHeader)
{
  vtkPolyData *axis = boxPipeline().axis->GetOutput(), *parts = boxPipeline().parts->GetOutput();
  EXPECT_EQ(arrays(parts->GetPointData()), arrays(axis->GetPointData()));
  const std::vector<std::string> names = filterTest::measureArrays();
  std::vector<std::string> expected = arrays(axis->GetCellData());
  expected.insert(expected.end(), { "PartId idtype 1", "PartLevel int 1", "PartRank idtype 1" });
  expected.insert(expected.end(), names.begin(), names.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(arrays(parts->GetCellData()), expected);
  expected = arrays(axis->GetFieldData());
  expected.emplace_back("NumberOfParts idtype 1");
  expected.emplace_back("SuggestedThreshold double " + std::to_string(names.size()));
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(arrays(parts->GetFieldData()), expected);
}

TEST(MedialPartDecomposition, HasTheColumnsOfItsHeader)
{
  std::vector<std::string> expected{ "Bounds double 6", "Centroid double 3", "Contacts idtype 1",
    "Dimension int 1", "Level int 1", "MinimumRadius double 1", "NeckRatio double 1",
    "Neighbors idtype 1", "OnLoop unsigned char 1", "PartId idtype 1", "PartRank idtype 1",
    "PrincipalLengths double 3", "Volume double 1" };
  for (int i = 0; vtkMedialPrune::GetMeasureName(i); ++i)
  {
    const bool isCount = std::string(vtkMedialPrune::GetMeasureUnit(i)) == "count";
    expected.push_back(
      vtkMedialPrune::GetMeasureName(i) + std::string(isCount ? " idtype 1" : " double 1"));
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(arrays(partTable()->GetRowData()), expected);
}

TEST(MedialPartDecomposition, HasTheArraysOfItsHeaderOnContacts)
{
  auto* contacts = vtkPolyData::SafeDownCast(boxPipeline().parts->GetOutputDataObject(2));
  EXPECT_EQ(arrays(contacts->GetCellData()), (std::vector<std::string>{ "ContactId idtype 1" }));
  EXPECT_EQ(arrays(contacts->GetFieldData()),
    (std::vector<std::string>{ "ContactPartOffsets idtype 1", "ContactParts idtype 1" }));
}

TEST(MedialPartDecomposition, KeepsTheCellsOfTheAxis)
{
  vtkPolyData *axis = boxPipeline().axis->GetOutput(), *parts = boxPipeline().parts->GetOutput();
  EXPECT_EQ(parts->GetPoints(), axis->GetPoints());
  EXPECT_EQ(parts->GetPolys(), axis->GetPolys());
  EXPECT_EQ(parts->GetLines(), axis->GetLines());
}

TEST(MedialPartDecomposition, SaysTheSameInCellsAndTable)
{
  vtkPolyData* parts = boxPipeline().parts->GetOutput();
  std::map<double, int> cells;
  for (vtkIdType i = 0; i < parts->GetNumberOfCells(); ++i)
  {
    const double part = cell("PartId", i);
    ++cells[part];
    EXPECT_EQ(cell("PartLevel", i), column("Level", part));
    EXPECT_EQ(cell("PartRank", i), column("PartRank", part));
    for (int measure = 0; vtkMedialPrune::GetMeasureName(measure); ++measure)
    {
      const char* name = vtkMedialPrune::GetMeasureName(measure);
      EXPECT_EQ(cell(vtkMedialPrune::GetMeasureArray(measure), i), column(name, part)) << name;
    }
  }
  EXPECT_EQ(static_cast<vtkIdType>(cells.size()), partTable()->GetNumberOfRows());
  for (const auto& [part, count] : cells)
  {
    EXPECT_EQ(column("PartId", part), part);
    EXPECT_EQ(column("TriangleCount", part), count);
  }
}

TEST(MedialPartDecomposition, CountsItsParts)
{
  EXPECT_EQ(
    boxPipeline().parts->GetOutput()->GetFieldData()->GetArray("NumberOfParts")->GetComponent(0, 0),
    partTable()->GetNumberOfRows());
}

TEST(MedialPartDecomposition, SuggestsThresholdsThatRemoveHalfOfTheOuterPartsOrMore)
{
  vtkDataArray* suggested =
    boxPipeline().parts->GetOutput()->GetFieldData()->GetArray("SuggestedThreshold");
  int toldBy = 0;
  for (int measure = 0; measure < suggested->GetNumberOfComponents(); ++measure)
  {
    const double threshold = suggested->GetComponent(0, measure);
    ASSERT_STREQ(suggested->GetComponentName(measure), vtkMedialPrune::GetMeasureName(measure));
    double outer = 0, removed = 0, volume = 0;
    for (vtkIdType part = 0; part < partTable()->GetNumberOfRows(); ++part)
    {
      const char* name = suggested->GetComponentName(measure);
      const bool isBelow = column("Level", part) == 1 && column(name, part) <= threshold;
      outer += column("Level", part) == 1;
      removed += isBelow;
      volume += isBelow ? column("RelativeVolume", part) : 0;
    }
    EXPECT_TRUE(threshold == 0 || (2 * removed >= outer && removed < outer && volume <= 0.1));
    toldBy += threshold > 0;
  }
  EXPECT_GT(toldBy, 5);
}

TEST(MedialPartDecomposition, SharesTheVolumeAmongTheParts)
{
  double volume = 0;
  for (vtkIdType part = 0; part < partTable()->GetNumberOfRows(); ++part)
  {
    volume += partTable()->GetValueByName(part, "RelativeVolume").ToDouble();
  }
  EXPECT_NEAR(volume, 1, 1e-12);
}

TEST(MedialPartDecomposition, HasBoundsAroundTheParts)
{
  vtkPolyData* parts = boxPipeline().parts->GetOutput();
  vtkDataArray* bounds = vtkDataArray::SafeDownCast(partTable()->GetColumnByName("Bounds"));
  for (vtkIdType i = 0; i < parts->GetNumberOfCells(); ++i)
  {
    double ofCell[6];
    parts->GetCellBounds(i, ofCell);
    const auto part = static_cast<vtkIdType>(cell("PartId", i));
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_LE(bounds->GetComponent(part, 2 * axis), ofCell[2 * axis]);
      EXPECT_GE(bounds->GetComponent(part, 2 * axis + 1), ofCell[2 * axis + 1]);
    }
  }
}

TEST(MedialPartDecomposition, ListsThePartsOfEveryContact)
{
  auto* contacts = vtkPolyData::SafeDownCast(boxPipeline().parts->GetOutputDataObject(2));
  ASSERT_GT(contacts->GetNumberOfCells(), 0);
  vtkDataArray* offsets = contacts->GetFieldData()->GetArray("ContactPartOffsets");
  vtkDataArray* parts = contacts->GetFieldData()->GetArray("ContactParts");
  ASSERT_EQ(offsets->GetNumberOfTuples(), contacts->GetNumberOfCells() + 1);
  EXPECT_EQ(offsets->GetComponent(contacts->GetNumberOfCells(), 0), parts->GetNumberOfTuples());
  for (vtkIdType i = 0; i < contacts->GetNumberOfCells(); ++i)
  {
    const double curve = contacts->GetCellData()->GetArray("ContactId")->GetComponent(i, 0);
    const auto id = static_cast<vtkIdType>(curve);
    EXPECT_LE(offsets->GetComponent(id, 0) + 1, offsets->GetComponent(id + 1, 0));
  }
  double shares = 0;
  for (vtkIdType part = 0; part < partTable()->GetNumberOfRows(); ++part)
  {
    shares += partTable()->GetValueByName(part, "Contacts").ToDouble();
  }
  EXPECT_EQ(shares, parts->GetNumberOfTuples());
}

TEST(MedialPartDecomposition, HasTheArraysOfItsHeaderOnTheGraph)
{
  auto* graph = vtkPolyData::SafeDownCast(boxPipeline().parts->GetOutputDataObject(3));
  EXPECT_EQ(arrays(graph->GetPointData()),
    (std::vector<std::string>{
      "Degree idtype 1", "NodeId idtype 1", "OnLoop unsigned char 1", "PartId idtype 1" }));
  EXPECT_EQ(arrays(graph->GetCellData()),
    (std::vector<std::string>{ "NodeId idtype 1", "PartId idtype 1" }));
}

TEST(MedialPartDecomposition, DrawsTheGraphFromPartsToNodes)
{
  auto* graph = vtkPolyData::SafeDownCast(boxPipeline().parts->GetOutputDataObject(3));
  vtkDataArray* nodes = graph->GetPointData()->GetArray("NodeId");
  vtkDataArray* parts = graph->GetPointData()->GetArray("PartId");
  vtkDataArray* degrees = graph->GetPointData()->GetArray("Degree");
  const vtkIdType nodeCount = graph->GetNumberOfPoints() - partTable()->GetNumberOfRows();
  ASSERT_GT(nodeCount, 0);
  EXPECT_EQ(graph->GetNumberOfVerts(), graph->GetNumberOfPoints());
  double degreesOfParts = 0;
  for (vtkIdType i = 0; i < graph->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(nodes->GetComponent(i, 0), i < nodeCount ? i : -1);
    EXPECT_EQ(parts->GetComponent(i, 0), i < nodeCount ? -1 : i - nodeCount);
    degreesOfParts += i < nodeCount ? 0 : degrees->GetComponent(i, 0);
  }
  EXPECT_EQ(graph->GetNumberOfLines(), degreesOfParts);
  for (vtkIdType line = graph->GetNumberOfVerts(); line < graph->GetNumberOfCells(); ++line)
  {
    vtkNew<vtkIdList> ends;
    graph->GetCellPoints(line, ends);
    EXPECT_EQ(graph->GetCellData()->GetArray("PartId")->GetComponent(line, 0),
      parts->GetComponent(ends->GetId(0), 0));
    EXPECT_EQ(graph->GetCellData()->GetArray("NodeId")->GetComponent(line, 0),
      nodes->GetComponent(ends->GetId(1), 0));
  }
}

TEST(MedialPartDecomposition, LimitsLevels)
{
  vtkNew<vtkMedialPartDecomposition> filter;
  const vtkMTimeType before = filter->GetMTime();
  filter->SetMaximumLevel(1);
  EXPECT_GT(filter->GetMTime(), before);
  filter->SetInputData(boxPipeline().axis->GetOutput());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("PartLevel")->GetRange()[1], 1);
  EXPECT_GT(
    boxPipeline().parts->GetOutput()->GetCellData()->GetArray("PartLevel")->GetRange()[1], 1);
}

/// What the filter says about the axis of the box after a change.
template <typename Change>
std::string refusal(const Change& change)
{
  const auto axis = filterTest::copy<vtkPolyData>(boxPipeline().axis->GetOutputDataObject(0));
  change(axis.Get());
  vtkNew<vtkMedialPartDecomposition> filter;
  filter->SetInputData(axis);
  return onlyError(filter);
}

TEST(MedialPartDecomposition, RefusesPolygons)
{
  const std::string error = refusal([](vtkPolyData* axis) {
    vtkNew<vtkCellArray> polys;
    polys->InsertNextCell({ 0, 1, 2, 3 });
    axis->SetPolys(polys);
  });
  EXPECT_NE(error.find("a cell has 4 corners instead of 3: take the output of vtkMedialAxis"),
    std::string::npos)
    << error;
}

TEST(MedialPartDecomposition, RefusesStrips)
{
  const std::string error = refusal([](vtkPolyData* axis) {
    vtkNew<vtkCellArray> strips;
    strips->InsertNextCell({ 0, 1, 2, 3 });
    axis->SetStrips(strips);
  });
  EXPECT_NE(error.find("triangle strips"), std::string::npos) << error;
}

TEST(MedialPartDecomposition, RefusesCellsWithACornerThatIsNotThere)
{
  const std::string error = refusal([](vtkPolyData* axis) {
    axis->GetPolys()->GetConnectivityArray()->SetComponent(
      0, 0, static_cast<double>(axis->GetNumberOfPoints()));
  });
  EXPECT_NE(error.find("a cell has the corner "), std::string::npos) << error;
}

TEST(MedialPartDecomposition, RefusesOffsetsOfCellsThatDontFit)
{
  const std::string error = refusal(
    [](vtkPolyData* axis) { axis->GetPolys()->GetOffsetsArray()->SetComponent(2, 0, 1e6); });
  EXPECT_NE(error.find("the offsets of the cells do not fit"), std::string::npos) << error;
}

TEST(MedialPartDecomposition, GivesEachPartAColorOfTheSameStrength)
{
  int checked = 0;
  for (vtkIdType part = 0; part < 300; ++part)
  {
    double rgb[3], lab[3];
    vtkMedialPartDecomposition::GetPartColor(part, rgb);
    if (std::all_of(rgb, rgb + 3, [](double c) { return c > 0 && c < 1; }))
    {
      vtkMath::RGBToLab(rgb, lab); // the core's own conversion must agree with VTK's
      EXPECT_NEAR(std::hypot(lab[1], lab[2]), 55, 0.1) << part;
      ++checked;
    }
  }
  EXPECT_GT(checked, 100); // many are outside what a screen can show
  double grey[3];
  vtkMedialPartDecomposition::GetPartColor(-1, grey);
  EXPECT_EQ(grey[0], grey[2]);
}

TEST(MedialPartDecomposition, RefusesAnEmptyAxis)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkMedialPartDecomposition> filter;
  filter->SetInputData(nothing);
  EXPECT_NE(onlyError(filter).find("take the output of vtkMedialAxis"), std::string::npos);
}
}
