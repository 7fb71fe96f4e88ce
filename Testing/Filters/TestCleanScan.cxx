// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCleanScan.h"

#include "FilterTest.h"
#include "Shapes.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

namespace
{
using filterTest::cloud;
using filterTest::onlyError;
using medial::Point;

/// A torus with a stray sample, and heights that scatter.
vtkSmartPointer<vtkPolyData> scan()
{
  std::vector<Point> points = shapes::torus().samples;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] *= 1 + 0.02 * std::sin(1000.0 * static_cast<double>(i));
  }
  points.emplace_back(0, 0, 4);
  return cloud(points);
}

double field(vtkDataObject* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

TEST(CleanScanFilter, HasTheArraysOfItsHeader)
{
  const auto input = scan();
  vtkNew<vtkCleanScan> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_LT(field(output, "NoiseAfter"), field(output, "NoiseBefore"));
  EXPECT_EQ(field(output, "DroppedOutliers"), 1);
  EXPECT_EQ(field(output, "SmoothingRounds"), 1);
  EXPECT_EQ(field(output, "Thinning"), 0.3);
  EXPECT_EQ(
    output->GetNumberOfPoints() + 1 + field(output, "ThinnedSamples"), input->GetNumberOfPoints());
  EXPECT_EQ(output->GetNumberOfVerts(), output->GetNumberOfPoints());
  EXPECT_FALSE(output->GetPointData()->GetNormals());
  filter->EstimateNormalsOn();
  filter->Update();
  ASSERT_TRUE(output->GetPointData()->GetNormals());
  EXPECT_EQ(output->GetPointData()->GetNormals()->GetNumberOfTuples(), output->GetNumberOfPoints());
}

TEST(CleanScanFilter, PassesNormalsOn)
{
  const auto input = scan();
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Any");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    normals->InsertNextTuple3(0, 1, static_cast<double>(i));
  }
  input->GetPointData()->SetNormals(normals);
  vtkNew<vtkCleanScan> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkPointData* points = filter->GetOutput()->GetPointData();
  ASSERT_TRUE(points->GetNormals());
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(
      points->GetNormals()->GetComponent(i, 2), points->GetArray("InputPoint")->GetComponent(i, 0));
  }
}

TEST(CleanScanFilter, RefusesTooFewPoints)
{
  vtkNew<vtkCleanScan> filter;
  filter->SetInputData(cloud({ Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0) }));
  EXPECT_NE(onlyError(filter).find("at least 20"), std::string::npos);
}
}
