// SPDX-License-Identifier: BSD-3-Clause
// (Compiled in: the library doesn't export it.)
#include "Base/Errors.h"
#include "Pipeline/SharedBalls.h"

#include "FilterTest.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

namespace
{
vtkSmartPointer<vtkUnstructuredGrid> ballGrid()
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->DeepCopy(filterTest::boxPipeline().balls->GetOutput());
  return result;
}

TEST(SharedBalls, AreThereForTheirReadersWhileTheyExist)
{
  medial::SharedBalls* first = nullptr;
  medial::SharedBalls* second = nullptr;
  {
    const medial::SharedBalls shared({ &first, &second });
    EXPECT_EQ(first, &shared);
    EXPECT_EQ(second, &shared);
  }
  EXPECT_EQ(first, nullptr);
  EXPECT_EQ(second, nullptr);
}

TEST(SharedBalls, AreReadOnceUntilTheyChange)
{
  const auto balls = ballGrid();
  medial::SharedBalls shared({});
  const auto read = medial::ballsOf(balls, &shared);
  EXPECT_EQ(medial::ballsOf(balls, &shared), read);
  EXPECT_NE(medial::ballsOf(balls, nullptr), read);
  const auto others = ballGrid();
  EXPECT_NE(medial::ballsOf(others, &shared), read);
  EXPECT_NE(medial::ballsOf(balls, &shared), read);
}

TEST(SharedBalls, AreCheckedAgainWhenTheyHaveChanged)
{
  const auto balls = ballGrid();
  medial::SharedBalls shared({});
  medial::ballsOf(balls, &shared);
  vtkDataArray* radii = balls->GetPointData()->GetArray("Radius");
  const double radius = radii->GetComponent(0, 0);
  radii->SetComponent(0, 0, -1);
  radii->Modified();
  EXPECT_THROW(medial::ballsOf(balls, &shared), medial::InvalidInput);
  EXPECT_THROW(medial::ballsOf(balls, &shared), medial::InvalidInput);
  radii->SetComponent(0, 0, radius);
  radii->Modified();
  EXPECT_EQ(medial::ballsOf(balls, &shared)->balls.front().radius, radius);
}
}
