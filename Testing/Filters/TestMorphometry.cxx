// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMorphometry.h"

#include "FilterTest.h"
#include "Rods.h"
#include "vtkCollectParts.h"
#include "vtkLocalThickness.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVariant.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{
using filterTest::boxPipeline;
using filterTest::ErrorLog;
using filterTest::failed;
using filterTest::onlyError;
using filterTest::smallBox;

/// The filter on what is known of the box.
vtkSmartPointer<vtkMorphometry> boxMorphometry()
{
  auto filter = vtkSmartPointer<vtkMorphometry>::New();
  filter->SetInputData(boxPipeline().balls->GetOutput());
  filter->SetAxisData(boxPipeline().axis->GetOutput());
  filter->SetSurfaceData(boxPipeline().crust->GetOutput());
  return filter;
}

double value(vtkMorphometry* filter, const char* column)
{
  return filter->GetOutput()->GetValueByName(0, column).ToDouble();
}

/// Not a number is as good as itself.
bool isSame(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// The balls of another solid.
vtkSmartPointer<vtkPolarBalls> sphereBalls()
{
  auto balls = vtkSmartPointer<vtkPolarBalls>::New();
  balls->SetInputData(filterTest::cloud(shapes::sphere().samples));
  balls->Update();
  return balls;
}
}

TEST(Morphometry, HasTheColumnsOfItsHeader)
{
  const auto filter = boxMorphometry();
  filter->SetName("box");
  filter->SetUnit("mm");
  filter->Update();
  vtkTable* table = filter->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  std::vector<std::string> expected{ "Name", "Unit" };
  for (int i = 0; vtkMorphometry::GetQuantityName(i); ++i)
  {
    expected.emplace_back(vtkMorphometry::GetQuantityName(i));
  }
  for (const char* column :
    { "Betti:0", "Betti:1", "Betti:2", "BettiSolid:0", "BettiSolid:1", "BettiSolid:2", "Verdict" })
  {
    expected.emplace_back(column);
  }
  auto* units =
    vtkStringArray::SafeDownCast(table->GetFieldData()->GetAbstractArray("ColumnUnits"));
  ASSERT_EQ(table->GetNumberOfColumns(), static_cast<vtkIdType>(expected.size()));
  ASSERT_EQ(units->GetNumberOfValues(), table->GetNumberOfColumns());
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    EXPECT_EQ(table->GetColumnName(i), expected[static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(table->GetValueByName(0, "Name").ToString(), "box");
  EXPECT_EQ(table->GetValueByName(0, "Unit").ToString(), "mm");
  EXPECT_EQ(units->GetValue(0), "");
  EXPECT_EQ(units->GetValue(2), "mm^3"); // TV
  EXPECT_TRUE(table->GetFieldData()->HasArray("Verdict"));
}

TEST(Morphometry, MeasuresTheBox)
{
  const auto filter = boxMorphometry();
  filter->Update();
  vtkPolyData* surface = boxPipeline().crust->GetOutput();
  const double volume = surface->GetFieldData()->GetArray("Volume")->GetComponent(0, 0);
  EXPECT_NEAR(value(filter, "BV"), volume, 1e-9 * volume);
  EXPECT_NEAR(value(filter, "TV"), smallBox().volume, 0.01 * smallBox().volume);
  EXPECT_NEAR(value(filter, "Tb.Th"), 1, 0.25); // 3 x 2 x 1, with edges
  EXPECT_NEAR(value(filter, "BS"), 22, 2);
  EXPECT_EQ(value(filter, "Euler"), 1);
  EXPECT_EQ(value(filter, "Conn.D"), 0);
  EXPECT_GT(value(filter, "Tb.NA"), 0);
  EXPECT_GT(value(filter, "DA"), 0.3); // 3 x 2 x 1
  EXPECT_EQ(value(filter, "Betti:0"), 1);
  EXPECT_EQ(value(filter, "Betti:1"), 0);
  EXPECT_TRUE(std::isnan(value(filter, "BettiSolid:0"))); // of points it isn't known
}

TEST(Morphometry, MeasuresWithinBounds)
{
  const auto filter = boxMorphometry();
  const medial::Point& corner = smallBox().samples.front();
  filter->SetBounds(corner.x() - 0.2, corner.x() + 0.2, corner.y() - 0.2, corner.y() + 0.2,
    corner.z() - 0.2, corner.z() + 0.2);
  filter->Update();
  const double whole = value(filter, "BV");
  filter->UseBoundsOn();
  filter->Update();
  EXPECT_NEAR(value(filter, "TV"), 0.4 * 0.4 * 0.4, 1e-12);
  EXPECT_LT(value(filter, "BV"), 0.4 * 0.4 * 0.4);
  EXPECT_GT(value(filter, "BV"), 0);
  EXPECT_LT(value(filter, "BV"), whole);
  EXPECT_TRUE(std::isnan(value(filter, "Conn.D")));
  EXPECT_TRUE(std::isfinite(value(filter, "Conn.D.VOI")));
  filter->SetMargin(0.1);
  filter->Update();
  EXPECT_NEAR(value(filter, "TV"), 0.2 * 0.2 * 0.2, 1e-12);
  filter->SetMargin(1);
  EXPECT_NE(onlyError(filter).find("smaller margin"), std::string::npos);
  EXPECT_TRUE(failed(filter));
}

TEST(Morphometry, MeasuresTheThicknessOfShells)
{
  std::vector<medial::Point> capsule = rods::ellipticRod(1, 1, 0.1, 1);
  const std::vector<medial::Point> marrow = rods::ellipticRod(0.6, 0.6, 0.1, 2);
  capsule.insert(capsule.end(), marrow.begin(), marrow.end());
  for (const auto& [samples, known] :
    { std::pair(capsule, 0.4), std::pair(shapes::hollowSphere().samples, 0.5) })
  {
    filterTest::Pipeline pipeline(filterTest::cloud(samples));
    vtkNew<vtkMorphometry> filter;
    filter->SetInputConnection(pipeline.balls->GetOutputPort());
    filter->SetAxisConnection(pipeline.axis->GetOutputPort());
    filter->SetSurfaceConnection(pipeline.crust->GetOutputPort());
    filter->Update();
    EXPECT_NEAR(value(filter, "Ct.Th"), known, 0.01 * known);
  }
  const auto box = boxMorphometry();
  box->Update();
  EXPECT_TRUE(std::isnan(value(box, "Ct.Th")));
}

/// The means over the volume are those of vtkLocalThickness, to the last bit.
TEST(Morphometry, HasTheMeansOfLocalThickness)
{
  const auto filter = boxMorphometry();
  filter->Update();
  auto* means = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  vtkNew<vtkLocalThickness> thickness;
  thickness->SetInputData(boxPipeline().balls->GetOutput());
  thickness->Update();
  auto* all = vtkTable::SafeDownCast(thickness->GetOutputDataObject(1));
  ASSERT_EQ(means->GetNumberOfRows(), 2);
  ASSERT_EQ(means->GetNumberOfColumns(), all->GetNumberOfColumns());
  for (vtkIdType row = 0; row < 2; ++row)
  {
    for (const char* column : { "Quantity", "Weight" })
    {
      EXPECT_EQ(means->GetValueByName(row, column), all->GetValueByName(row, column)) << column;
    }
    for (const char* column : { "Mean", "Deviation", "Minimum", "Maximum", "Number" })
    {
      EXPECT_TRUE(isSame(
        means->GetValueByName(row, column).ToDouble(), all->GetValueByName(row, column).ToDouble()))
        << column;
    }
  }
  auto* histogram = vtkDataArray::SafeDownCast(means->GetColumnByName("Histogram"));
  auto* known = vtkDataArray::SafeDownCast(all->GetColumnByName("Histogram"));
  for (int i = 0; i < 40; ++i)
  {
    EXPECT_EQ(histogram->GetComponent(0, i), known->GetComponent(0, i)) << i;
  }
  EXPECT_EQ(means->GetValueByName(0, "Mean").ToDouble(), value(filter, "Tb.Th"));
  EXPECT_TRUE(isSame(means->GetValueByName(1, "Mean").ToDouble(), value(filter, "Tb.Sp")));
  EXPECT_EQ(means->GetFieldData()->GetArray("VolumeShare")->GetComponent(0, 0),
    all->GetFieldData()->GetArray("VolumeShare")->GetComponent(0, 0));
}

TEST(Morphometry, FindsTheBlocksOfItsBalls)
{
  const auto alone = boxMorphometry();
  alone->Update();
  vtkNew<vtkMultiBlockDataSet> axes, surfaces;
  axes->SetBlock(1, boxPipeline().axis->GetOutput());
  surfaces->SetBlock(0, filterTest::dataOf(meshes::sphere()));
  surfaces->SetBlock(2, boxPipeline().crust->GetOutput());
  const auto filter = boxMorphometry();
  filter->SetAxisData(axes);
  filter->SetSurfaceData(surfaces);
  filter->Update();
  EXPECT_EQ(value(filter, "BV"), value(alone, "BV"));
  surfaces->SetBlock(2, nullptr);
  surfaces->Modified();
  EXPECT_NE(onlyError(filter).find("no block of the surface"), std::string::npos);
}

/// A collection gives a table for each object, and vtkCollectParts one of all.
TEST(Morphometry, MeasuresCollections)
{
  vtkNew<vtkMultiBlockDataSet> samples;
  samples->SetBlock(0, filterTest::cloud(shapes::sphere().samples));
  samples->SetBlock(1, filterTest::cloud(smallBox().samples));
  filterTest::Pipeline pipeline(samples);
  vtkNew<vtkMorphometry> filter;
  filter->SetInputConnection(pipeline.balls->GetOutputPort());
  filter->SetAxisConnection(pipeline.axis->GetOutputPort());
  filter->SetSurfaceConnection(pipeline.crust->GetOutputPort());
  vtkNew<vtkCollectParts> collect;
  collect->SetInputConnection(filter->GetOutputPort());
  collect->Update();
  auto* table = vtkTable::SafeDownCast(collect->GetOutputDataObject(0));
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  EXPECT_EQ(table->GetValueByName(1, "ObjectId").ToInt(), 1);
  EXPECT_NEAR(table->GetValueByName(0, "BV").ToDouble(), shapes::sphere().volume, 0.1);
  EXPECT_NEAR(table->GetValueByName(1, "BV").ToDouble(), smallBox().volume, 0.3);
}

TEST(Morphometry, RefusesWhatWasMadeFromOtherBalls)
{
  const auto filter = boxMorphometry();
  const auto others = sphereBalls();
  filter->SetInputData(others->GetOutput());
  EXPECT_NE(onlyError(filter).find("balls"), std::string::npos);
  EXPECT_TRUE(failed(filter));
  const auto second = boxMorphometry();
  auto moved = filterTest::copy<vtkPolyData>(boxPipeline().crust->GetOutput());
  vtkIdType point = 0;
  while (moved->GetPointData()->GetArray("SampleId")->GetComponent(point, 0) < 0)
  {
    ++point;
  }
  const medial::Point sample(moved->GetPoint(point));
  moved->GetPoints()->SetPoint(point, sample.x() + 1, sample.y(), sample.z());
  second->SetSurfaceData(moved);
  EXPECT_NE(onlyError(second).find("surface was not made from these balls"), std::string::npos);
}

TEST(Morphometry, MeasuresTheSameFromFiles)
{
  const auto filter = boxMorphometry(), fromFiles = boxMorphometry();
  fromFiles->SetInputData(filterTest::writtenAndRead(boxPipeline().balls->GetOutput()));
  fromFiles->SetAxisData(filterTest::writtenAndRead(boxPipeline().axis->GetOutput()));
  fromFiles->SetSurfaceData(filterTest::writtenAndRead(boxPipeline().crust->GetOutput()));
  filter->Update();
  fromFiles->Update();
  for (const char* column : { "TV", "BV", "BS", "DA", "Tb.NA", "Euler" })
  {
    EXPECT_EQ(value(filter, column), value(fromFiles, column)) << column;
  }
}

TEST(Morphometry, TellsItsTable)
{
  int quantities = 0;
  for (; vtkMorphometry::GetQuantityName(quantities); ++quantities)
  {
    EXPECT_TRUE(vtkMorphometry::GetQuantityDescription(quantities));
    EXPECT_TRUE(vtkMorphometry::GetQuantityFormula(quantities));
    EXPECT_NE(vtkMorphometry::GetQuantityUnit(quantities, "mm"), "");
  }
  EXPECT_GT(quantities, 20);
  EXPECT_EQ(vtkMorphometry::GetQuantityName(-1), nullptr);
  EXPECT_EQ(vtkMorphometry::GetQuantityUnit(quantities, "mm"), "");
}
