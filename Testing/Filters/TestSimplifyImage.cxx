// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include "vtkBoundarySamples.h"
#include "vtkImageBoundary.h"
#include "vtkSimplifyShape.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <string>

namespace
{
using filterTest::cloud;
using filterTest::onlyError;
using filterTest::same;
using filterTest::smallBox;

vtkSmartPointer<vtkImageData> ballOfVoxels()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(20, 20, 20);
  image->SetSpacing(1, 1, 1.5);
  image->AllocateScalars(VTK_SHORT, 1);
  for (int i = 0; i < 8000; ++i)
  {
    const double r = std::hypot(i % 20 - 9.5, i / 20 % 20 - 9.5, i / 400 - 9.5);
    image->GetPointData()->GetScalars()->SetTuple1(i, r < 7 ? 100 + 20 * r : 0);
  }
  return image;
}

TEST(SimplifyImage, TakesAnImage)
{
  const auto image = ballOfVoxels();
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(image);
  simplify->GetBoundarySamples()->SetSpacing(1);
  simplify->GetImageBoundary()->SetSolidToIsoValue();
  simplify->GetImageBoundary()->SetIsoValue(50);
  simplify->Update();
  vtkFieldData* field = simplify->GetOutput()->GetFieldData();
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(field->GetArray("BettiCrust")->GetComponent(0, k), k == 0 ? 1 : 0);
    EXPECT_EQ(field->GetArray("BettiSolid")->GetComponent(0, k), k == 0 ? 1 : 0);
    EXPECT_EQ(field->GetArray("BettiSegmentation")->GetComponent(0, k), k == 0 ? 1 : 0);
  }
  vtkNew<vtkImageBoundary> surface;
  surface->SetInputData(image);
  surface->SetSolidToIsoValue();
  surface->SetIsoValue(50);
  vtkNew<vtkSimplifyShape> ofSurface;
  ofSurface->SetInputConnection(surface->GetOutputPort());
  ofSurface->GetBoundarySamples()->SetSpacing(1);
  ofSurface->Update();
  EXPECT_TRUE(same(simplify->GetOutput(), ofSurface->GetOutput()));
}

TEST(SimplifyImage, MakesTheSurfaceOfAnImageAgainWhereItChanges)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(ballOfVoxels());
  simplify->GetBoundarySamples()->SetSpacing(1);
  EXPECT_NE(onlyError(simplify).find("which voxels are the solid?"), std::string::npos);
  simplify->GetImageBoundary()->SetSolidToIsoValue();
  simplify->GetImageBoundary()->SetIsoValue(50);
  simplify->Update();
  const vtkMTimeType made = simplify->GetMedialAxis()->GetOutput()->GetMTime();
  simplify->SetSchedule("t1");
  simplify->Update();
  EXPECT_EQ(simplify->GetMedialAxis()->GetOutput()->GetMTime(), made);
  simplify->GetImageBoundary()->SetIsoValue(180); // hollow
  simplify->Update();
  EXPECT_GT(simplify->GetMedialAxis()->GetOutput()->GetMTime(), made);
  EXPECT_EQ(simplify->GetOutput()->GetFieldData()->GetArray("BettiCrust")->GetComponent(0, 2), 1);
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->Update();
  EXPECT_FALSE(simplify->GetOutput()->GetFieldData()->HasArray("BettiSegmentation"));
}
}
