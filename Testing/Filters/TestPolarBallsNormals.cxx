// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

namespace
{
using filterTest::cloud;
using filterTest::onlyError;
using filterTest::smallBox;

/// A thin plate: its samples are farther apart than its sides.
vtkSmartPointer<vtkPolyData> plateWithNormals(double orientation)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 400; ++i)
  {
    for (const double side : { -1.0, 1.0 })
    {
      points->InsertNextPoint(
        i % 20 + 0.3 * std::sin(i), i / 20 + 0.3 * std::cos(3 * i), 0.3 * side);
      normals->InsertNextTuple3(0, 0, side * orientation);
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->GetPointData()->SetNormals(normals);
  return result;
}

TEST(PolarBallsFilter, TakesNormalsForTheSides)
{
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(plateWithNormals(1));
  filter->Update();
  const auto radii = [&] { return filter->GetOutput()->GetPointData()->GetArray("InnerRadius"); };
  vtkNew<vtkDoubleArray> outwards;
  outwards->DeepCopy(radii());
  for (vtkIdType b = 0; b < filter->GetOutput()->GetNumberOfPoints(); ++b)
  {
    // The centre of an inner ball is between the sheets.
    const double z = filter->GetOutput()->GetPoint(b)[2];
    EXPECT_TRUE(radii()->GetComponent(b, 0) == 0 || std::abs(z) < 0.3) << z;
  }
  // By another name, and turned around.
  const auto inwards = plateWithNormals(-1);
  const vtkSmartPointer<vtkDataArray> normals = inwards->GetPointData()->GetNormals();
  normals->SetName("Normals");
  inwards->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::NORMALS);
  inwards->GetPointData()->AddArray(normals);
  filter->SetInputData(inwards);
  filter->Update();
  ASSERT_EQ(radii()->GetNumberOfTuples(), outwards->GetNumberOfTuples());
  for (vtkIdType b = 0; b < outwards->GetNumberOfTuples(); ++b)
  {
    EXPECT_EQ(radii()->GetComponent(b, 0), outwards->GetComponent(b, 0));
  }
}

TEST(PolarBallsFilter, RefusesNormalsThatDontFitThePoints)
{
  const auto samples = cloud(smallBox().samples);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(2);
  normals->SetNumberOfTuples(samples->GetNumberOfPoints());
  normals->Fill(1);
  samples->GetPointData()->AddArray(normals);
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(samples);
  EXPECT_NE(onlyError(filter).find("'Normals'"), std::string::npos);
}
}
