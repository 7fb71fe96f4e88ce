// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include "vtkLocalThickness.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <string>

namespace
{
using filterTest::arrays;
using filterTest::boxPipeline;
using filterTest::onlyError;

/// Of the small box, on its samples.
vtkSmartPointer<vtkLocalThickness> boxThickness()
{
  auto result = vtkSmartPointer<vtkLocalThickness>::New();
  result->SetInputConnection(boxPipeline().balls->GetOutputPort());
  return result;
}

vtkTable* table(vtkAlgorithm* filter, int port)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
}

double mean(vtkAlgorithm* filter, const std::string& quantity, const std::string& weight)
{
  vtkTable* means = table(filter, 1);
  for (vtkIdType row = 0; row < means->GetNumberOfRows(); ++row)
  {
    if (means->GetValueByName(row, "Quantity").ToString() == quantity &&
      means->GetValueByName(row, "Weight").ToString() == weight)
    {
      return means->GetValueByName(row, "Mean").ToDouble();
    }
  }
  ADD_FAILURE() << "no row " << quantity << ", " << weight;
  return 0;
}

TEST(LocalThickness, HasTheArraysOfItsHeader)
{
  const auto thickness = boxThickness();
  thickness->Update();
  vtkDataSet* output = thickness->GetOutput();
  EXPECT_TRUE(output->IsA("vtkPolyData"));
  EXPECT_EQ(output->GetNumberOfCells(), output->GetNumberOfPoints());
  EXPECT_EQ(arrays(output->GetPointData()),
    (std::vector<std::string>{ "Separation double 1", "SeparationBall idtype 1",
      "Thickness double 1", "ThicknessBall idtype 1" }));
  EXPECT_EQ(arrays(table(thickness, 1)->GetRowData()),
    (std::vector<std::string>{ "Deviation double 1", "Histogram idtype 40", "Maximum double 1",
      "Mean double 1", "Minimum double 1", "Number idtype 1", "Quantity string 1",
      "Weight string 1" }));
  EXPECT_EQ(arrays(table(thickness, 1)->GetFieldData()),
    (std::vector<std::string>{ "Margin double 1", "VolumeShare double 1" }));
  EXPECT_EQ(table(thickness, 2)->GetNumberOfRows(), 0);
  thickness->MeasureSeparationOff();
  thickness->Update();
  EXPECT_EQ(arrays(thickness->GetOutput()->GetPointData()),
    (std::vector<std::string>{ "Thickness double 1", "ThicknessBall idtype 1" }));
}

TEST(LocalThickness, HasTheColumnsOfItsHeaderForThinPlaces)
{
  const auto thickness = boxThickness();
  thickness->SetAxisConnection(boxPipeline().axis->GetOutputPort());
  thickness->Update();
  std::vector<std::string> expected{ "AxisPoint idtype 1", "Depth double 1", "Place double 3",
    "Thickness double 1" };
  EXPECT_EQ(arrays(table(thickness, 2)->GetRowData()), expected);
  thickness->SetAxisConnection(boxPipeline().parts->GetOutputPort());
  thickness->Update();
  expected.insert(expected.begin() + 2, "PartId idtype 1");
  EXPECT_EQ(arrays(table(thickness, 2)->GetRowData()), expected);
}

TEST(LocalThickness, IsTheDiameterOfABallOnTheSample)
{
  const auto thickness = boxThickness();
  thickness->Update();
  vtkUnstructuredGrid* balls = boxPipeline().balls->GetOutput();
  vtkPointData* data = thickness->GetOutput()->GetPointData();
  const double spacing = balls->GetFieldData()->GetArray("SampleSpacing")->GetComponent(0, 0);
  for (vtkIdType p = 0; p < thickness->GetOutput()->GetNumberOfPoints(); ++p)
  {
    const auto ball = static_cast<vtkIdType>(data->GetArray("ThicknessBall")->GetComponent(p, 0));
    const double diameter = data->GetArray("Thickness")->GetComponent(p, 0);
    if (ball < 0) // at a sharp edge
    {
      EXPECT_TRUE(std::isnan(diameter));
      continue;
    }
    double at[3], center[3];
    thickness->GetOutput()->GetPoint(p, at);
    balls->GetPoint(ball, center);
    const double radius = balls->GetPointData()->GetArray("Radius")->GetComponent(ball, 0);
    EXPECT_EQ(balls->GetPointData()->GetArray("Side")->GetComponent(ball, 0), 1);
    EXPECT_LE(diameter, 2 * radius);
    EXPECT_GT(diameter, 1.5 * radius);
    EXPECT_LE(std::sqrt(vtkMath::Distance2BetweenPoints(at, center)), radius + 0.2501 * spacing);
  }
}

TEST(LocalThickness, MeasuresAtThePointsOfAnyDataSet)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(7, 5, 3);
  image->SetSpacing(0.6, 0.6, 0.6);
  image->SetOrigin(-1.8, -1.2, -0.6); // the box is 3 x 2 x 1 about 0
  const auto thickness = boxThickness();
  thickness->SetPlacesData(image);
  thickness->Update();
  vtkDataSet* output = thickness->GetOutput();
  ASSERT_TRUE(output->IsA("vtkImageData"));
  ASSERT_EQ(output->GetNumberOfPoints(), 105);
  vtkDataArray* values = output->GetPointData()->GetArray("Thickness");
  EXPECT_NEAR(values->GetComponent(output->FindPoint(0, 0, 0), 0), 1, 0.03);
  EXPECT_TRUE(std::isnan(values->GetComponent(output->FindPoint(-1.8, -1.2, -0.6), 0)));
  thickness->SetInputConnection(1, boxPipeline().crust->GetOutputPort());
  thickness->Update();
  EXPECT_TRUE(thickness->GetOutput()->IsA("vtkPolyData"));
  EXPECT_TRUE(thickness->GetOutput()->GetPointData()->HasArray("SampleId")); // passed on
}

TEST(LocalThickness, TellsMeansByWeight)
{
  const shapes::Shape shape = shapes::twoHolePlate();
  vtkNew<vtkPolarBalls> balls;
  balls->SetInputData(filterTest::cloud(shape.samples));
  vtkNew<vtkLocalThickness> thickness;
  thickness->SetInputConnection(balls->GetOutputPort());
  thickness->Update();
  for (const char* weight : { "volume", "places", "balls" })
  {
    EXPECT_NEAR(mean(thickness, "Thickness", weight), 0.4, 0.004) << weight;
  }
  thickness->SetNumberOfPoints(0);
  thickness->Update();
  EXPECT_TRUE(std::isnan(mean(thickness, "Thickness", "volume")));
}

TEST(LocalThickness, UsesTheNormalsThatCameWithTheSamples)
{
  const shapes::Shape shape = shapes::sphere(0.4);
  const auto points = filterTest::cloud(shape.samples);
  vtkNew<vtkPolarBalls> balls;
  balls->SetInputData(points);
  balls->Update();
  EXPECT_FALSE(balls->GetOutput()->GetFieldData()->HasArray("SampleNormals"));
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (const medial::Point& p : shape.samples)
  {
    normals->InsertNextTuple(medial::Point(7 * p).data());
  }
  points->GetPointData()->SetNormals(normals);
  points->Modified();
  balls->Update();
  vtkDataArray* kept = balls->GetOutput()->GetFieldData()->GetArray("SampleNormals");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->GetNumberOfTuples(), medial::count(shape.samples));
  vtkNew<vtkLocalThickness> thickness;
  thickness->SetInputConnection(balls->GetOutputPort());
  thickness->Update();
  EXPECT_NEAR(mean(thickness, "Thickness", "volume"), 2, 1e-9);
  kept->SetComponent(3, 0, 5);
  kept->Modified();
  balls->GetOutput()->Modified();
  vtkNew<vtkLocalThickness> refused;
  refused->SetInputData(balls->GetOutput());
  EXPECT_NE(onlyError(refused).find("SampleNormals"), std::string::npos);
}

TEST(LocalThickness, RefusesWhatDoesNotFit)
{
  const auto thickness = boxThickness();
  thickness->SetTolerance(-1);
  EXPECT_NE(onlyError(thickness).find("tolerance"), std::string::npos);
  EXPECT_EQ(thickness->GetOutput()->GetNumberOfPoints(), 0);
  thickness->SetTolerance(0.25);
  thickness->UseBoundsOn();
  thickness->SetBounds(0, 1, 0, 1, 1, 1);
  EXPECT_NE(onlyError(thickness).find("volume of interest"), std::string::npos);
  thickness->UseBoundsOff();
  thickness->SetMinimumDepth(-1);
  thickness->SetAxisConnection(boxPipeline().axis->GetOutputPort());
  EXPECT_NE(onlyError(thickness).find("depth"), std::string::npos);
  thickness->SetMinimumDepth(0.1);
  vtkNew<vtkPolarBalls> other;
  other->SetInputData(filterTest::cloud(shapes::sphere().samples));
  thickness->SetInputConnection(other->GetOutputPort());
  EXPECT_NE(onlyError(thickness).find("balls"), std::string::npos);
}
}
