// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"
#include "Struts.h"

#include "vtkPlatesAndRods.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <limits>
#include <set>

namespace
{
using filterTest::arrays;
using filterTest::onlyError;

/// Two plates and a rod between them, not pruned.
filterTest::Pipeline& pipeline()
{
  static filterTest::Pipeline result(
    filterTest::cloud(shapes::strutSamples(shapes::platesAndRod(), 0.12, 0.05, 1)));
  static const bool updated = [] {
    result.crust->SetInputConnection(1, result.axis->GetOutputPort());
    result.crust->Update();
    return true;
  }();
  static_cast<void>(updated);
  return result;
}

/// The filter on copies of its inputs, updated.
struct Elements
{
  explicit Elements(bool withSurface = true)
  {
    this->filter->SetInputData(filterTest::copy<vtkPolyData>(pipeline().axis->GetOutput()));
    if (withSurface)
    {
      this->filter->SetInputData(1, filterTest::copy<vtkPolyData>(pipeline().crust->GetOutput()));
    }
  }

  vtkPolyData* data(int port)
  {
    this->filter->Update();
    return vtkPolyData::SafeDownCast(this->filter->GetOutputDataObject(port));
  }
  vtkTable* table()
  {
    this->filter->Update();
    return vtkTable::SafeDownCast(this->filter->GetOutputDataObject(1));
  }

  vtkNew<vtkPlatesAndRods> filter;
};

const std::vector<std::string> counts{ "NumberOfPlates idtype 1", "NumberOfRods idtype 1",
  "PlatePlateJunctions idtype 1", "PlateRodJunctions idtype 1", "PlateVolume double 1",
  "RodRodJunctions idtype 1", "RodVolume double 1" };

std::vector<std::string> with(std::vector<std::string> some, const std::vector<std::string>& more)
{
  some.insert(some.end(), more.begin(), more.end());
  std::sort(some.begin(), some.end());
  return some;
}

double field(vtkDataObject* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}
}

TEST(PlatesAndRods, AddsTheArraysOfItsHeader)
{
  Elements elements;
  vtkPolyData *axis = pipeline().axis->GetOutput(), *output = elements.data(0);
  EXPECT_EQ(arrays(output->GetPointData()),
    with(arrays(axis->GetPointData()),
      { "ElementId idtype 1", "PlateOrRod unsigned char 1", "SheetWidth double 1",
        "Thickness double 1", "WidthRatio double 1" }));
  EXPECT_EQ(arrays(output->GetCellData()),
    with(arrays(axis->GetCellData()), { "ElementId idtype 1", "PlateOrRod unsigned char 1" }));
  EXPECT_EQ(arrays(output->GetFieldData()), with(arrays(axis->GetFieldData()), counts));
  vtkPolyData *crust = pipeline().crust->GetOutput(), *surface = elements.data(2);
  EXPECT_EQ(arrays(surface->GetCellData()),
    with(arrays(crust->GetCellData()),
      { "ElementId idtype 1", "PlateOrRod unsigned char 1", "Thickness double 1" }));
}

TEST(PlatesAndRods, HasTheColumnsOfItsHeader)
{
  Elements elements;
  EXPECT_EQ(arrays(elements.table()->GetRowData()),
    with({},
      { "Area double 1", "Centroid double 3", "Direction double 3", "ElementId idtype 1",
        "Length double 1", "MaximumThickness double 1", "MeanThickness double 1",
        "MinimumThickness double 1", "Neighbors idtype 1", "PlateOrRod unsigned char 1",
        "Volume double 1" }));
  EXPECT_EQ(arrays(elements.table()->GetFieldData()),
    with(counts, { "NeighborElements idtype 1", "NeighborOffsets idtype 1" }));
}

TEST(PlatesAndRods, CountsTwoPlatesAndTheRodBetweenThem)
{
  Elements elements;
  vtkTable* table = elements.table();
  ASSERT_EQ(table->GetNumberOfRows(), 3);
  const std::vector<int> classes{ 1, 1, 2 };
  for (vtkIdType row = 0; row < 3; ++row)
  {
    EXPECT_EQ(table->GetValueByName(row, "PlateOrRod").ToInt(), classes[row]);
    EXPECT_EQ(table->GetValueByName(row, "ElementId").ToInt(), row);
    EXPECT_EQ(table->GetValueByName(row, "Neighbors").ToInt(), row == 2 ? 2 : 1);
  }
  for (vtkDataObject* data :
    { static_cast<vtkDataObject*>(elements.data(0)), static_cast<vtkDataObject*>(table) })
  {
    EXPECT_EQ(field(data, "NumberOfPlates"), 2);
    EXPECT_EQ(field(data, "NumberOfRods"), 1);
    EXPECT_EQ(field(data, "PlateRodJunctions"), 2);
    EXPECT_EQ(field(data, "PlatePlateJunctions"), 0);
    EXPECT_EQ(field(data, "RodRodJunctions"), 0);
  }
  EXPECT_NEAR(field(table, "PlateVolume") + field(table, "RodVolume"),
    field(pipeline().crust->GetOutput(), "Volume"), 0.05);
}

TEST(PlatesAndRods, TheClassOfPointsAndCellsIsThatOfTheirElement)
{
  Elements elements;
  vtkTable* table = elements.table();
  vtkPolyData *axis = elements.data(0), *surface = elements.data(2);
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(axis->GetPointData()),
         static_cast<vtkFieldData*>(axis->GetCellData()),
         static_cast<vtkFieldData*>(surface->GetCellData()) })
  {
    vtkDataArray *ids = data->GetArray("ElementId"), *classes = data->GetArray("PlateOrRod");
    std::set<double> seen;
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      const double element = ids->GetComponent(i, 0);
      seen.insert(element);
      const int expected = element < 0
        ? 0
        : table->GetValueByName(static_cast<vtkIdType>(element), "PlateOrRod").ToInt();
      EXPECT_EQ(classes->GetComponent(i, 0), expected);
    }
    seen.erase(-1);
    EXPECT_EQ(seen, (std::set<double>{ 0, 1, 2 }));
  }
}

TEST(PlatesAndRods, TheSurfaceOfTheRodIsBetweenThePlates)
{
  Elements elements;
  vtkPolyData* surface = elements.data(2);
  vtkDataArray* classes = surface->GetCellData()->GetArray("PlateOrRod");
  vtkDataArray* thickness = surface->GetCellData()->GetArray("Thickness");
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    surface->GetCellBounds(i, bounds);
    const bool between = bounds[0] > -0.4 && bounds[1] < 0.4;
    const bool inPlate = bounds[0] > 0.75 || bounds[1] < -0.75;
    if (between || inPlate)
    {
      EXPECT_EQ(classes->GetComponent(i, 0), between ? 2 : 1);
      EXPECT_NEAR(thickness->GetComponent(i, 0), 0.24, 0.03);
    }
  }
}

TEST(PlatesAndRods, WorksWithoutASurface)
{
  Elements elements(false);
  EXPECT_EQ(elements.table()->GetNumberOfRows(), 3);
  EXPECT_TRUE(filterTest::isEmpty(elements.data(2)));
}

TEST(PlatesAndRods, LeavesOutWhatIsPrunedAway)
{
  filterTest::Pipeline& box = filterTest::boxPipeline();
  vtkNew<vtkPlatesAndRods> filter;
  filter->SetInputData(filterTest::copy<vtkPolyData>(box.prune->GetOutput()));
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  std::vector<char> used(static_cast<std::size_t>(output->GetNumberOfPoints()), 0);
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    output->GetCellPoints(i, size, corners);
    std::for_each(corners, corners + size, [&used](vtkIdType p) { used[p] = 1; });
  }
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const double element = output->GetPointData()->GetArray("ElementId")->GetComponent(p, 0);
    EXPECT_EQ(element >= 0, used[p] == 1);
  }
}

TEST(PlatesAndRods, TheSameAfterATripThroughAFile)
{
  Elements elements;
  vtkNew<vtkPlatesAndRods> again;
  again->SetInputDataObject(filterTest::writtenAndRead(pipeline().axis->GetOutput()));
  again->Update();
  EXPECT_TRUE(filterTest::same(elements.table(), again->GetOutputDataObject(1)));
}

TEST(PlatesAndRods, RefusesRatiosThatMakeNoSense)
{
  Elements elements;
  elements.filter->SetPlateRatio(0.5);
  EXPECT_NE(onlyError(elements.filter).find("take a number from 1 on"), std::string::npos);
  EXPECT_TRUE(filterTest::failed(elements.filter));
  elements.filter->SetPlateRatio(1.5);
  elements.filter->SetNeckRatio(std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(onlyError(elements.filter).find("take a number from 0 to 1"), std::string::npos);
}

TEST(PlatesAndRods, RefusesTheSurfaceOfAnotherAxis)
{
  Elements elements;
  vtkDataArray* balls = vtkPolyData::SafeDownCast(elements.filter->GetInputDataObject(1, 0))
                          ->GetCellData()
                          ->GetArray("InnerBall");
  balls->SetComponent(0, 0, 1e8);
  EXPECT_NE(onlyError(elements.filter).find("vtkPowerCrust"), std::string::npos);
  EXPECT_TRUE(filterTest::failed(elements.filter));
}

TEST(PlatesAndRods, RefusesAnAxisWithoutErosionThickness)
{
  Elements elements;
  vtkPolyData::SafeDownCast(elements.filter->GetInputDataObject(0, 0))
    ->GetPointData()
    ->RemoveArray("ErosionThickness");
  EXPECT_NE(onlyError(elements.filter).find("ErosionThickness"), std::string::npos);
  EXPECT_TRUE(filterTest::failed(elements.filter));
}
