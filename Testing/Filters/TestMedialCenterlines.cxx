// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"
#include "Rods.h"

#include "vtkMedialCenterlines.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace
{
using filterTest::arrays;

/// Balls and axis of samples, and the lines along its middle.
struct Tracing
{
  explicit Tracing(const std::vector<medial::Point>& samples)
    : stages(filterTest::cloud(samples))
  {
    this->lines->SetInputConnection(this->stages.axis->GetOutputPort());
  }

  vtkPolyData* branches()
  {
    this->lines->Update();
    return this->lines->GetOutput();
  }
  vtkPolyData* nodes() { return vtkPolyData::SafeDownCast(this->lines->GetOutputDataObject(1)); }

  filterTest::Pipeline stages;
  vtkNew<vtkMedialCenterlines> lines;
};

const std::vector<medial::Point>& treeSamples()
{
  static const std::vector<medial::Point> samples =
    rods::samples(rods::vesselTree().rods(), 0.1, 1);
  return samples;
}

double value(vtkFieldData* data, const char* name, vtkIdType place, int component = 0)
{
  return data->GetArray(name)->GetComponent(place, component);
}

TEST(MedialCenterlines, HaveTheArraysOfTheirHeader)
{
  Tracing run(treeSamples());
  vtkPolyData* branches = run.branches();
  EXPECT_EQ(arrays(branches->GetPointData()),
    (std::vector<std::string>{ "MaximumInscribedSphereRadius double 1" }));
  EXPECT_STREQ(branches->GetPointData()->GetScalars()->GetName(), "MaximumInscribedSphereRadius");
  EXPECT_EQ(arrays(branches->GetCellData()),
    (std::vector<std::string>{ "BranchId idtype 1", "BranchNodes idtype 2", "Length double 1",
      "MeanRadius double 1", "MinimumRadius double 1" }));
  EXPECT_TRUE(branches->GetFieldData()->HasArray("OpenedVoids"));
  EXPECT_TRUE(branches->GetFieldData()->HasArray("BettiAxis"));  // passed on
  EXPECT_FALSE(branches->GetFieldData()->HasArray("BallOwner")); // of balls
  EXPECT_EQ(arrays(run.nodes()->GetPointData()),
    (std::vector<std::string>{ "AtPlate unsigned char 1", "Degree idtype 1",
      "MaximumInscribedSphereRadius double 1", "NodeId idtype 1" }));
}

TEST(MedialCenterlines, AreTheVesselsOfATree)
{
  Tracing run(treeSamples());
  vtkPolyData* branches = run.branches();
  ASSERT_EQ(branches->GetNumberOfCells(), 8);
  ASSERT_EQ(branches->GetNumberOfLines(), 8);
  ASSERT_EQ(run.nodes()->GetNumberOfPoints(), 8);
  ASSERT_EQ(run.nodes()->GetNumberOfVerts(), 8);
  double length = 0;
  for (vtkIdType i = 0; i < 8; ++i)
  {
    vtkIdList* points = branches->GetCell(i)->GetPointIds();
    EXPECT_EQ(value(branches->GetCellData(), "BranchId", i), i);
    EXPECT_EQ(value(branches->GetCellData(), "BranchNodes", i, 0), points->GetId(0));
    EXPECT_EQ(value(branches->GetCellData(), "BranchNodes", i, 1),
      points->GetId(points->GetNumberOfIds() - 1));
    const double mean = value(branches->GetCellData(), "MeanRadius", i);
    EXPECT_GT(mean, value(branches->GetCellData(), "MinimumRadius", i));
    EXPECT_GT(mean, 0.24);
    EXPECT_LT(mean, 0.5);
    length += value(branches->GetCellData(), "Length", i);
  }
  double expected = 0;
  for (const rods::Rod& rod : rods::vesselTree().rods())
  {
    expected += rod.length();
  }
  EXPECT_NEAR(length / expected, 1, 0.02);
}

TEST(MedialCenterlines, ShareThePointsOfNodes)
{
  Tracing run(treeSamples());
  vtkPolyData* branches = run.branches();
  for (vtkIdType i = 0; i < run.nodes()->GetNumberOfPoints(); ++i)
  {
    double ofNode[3], ofBranch[3];
    run.nodes()->GetPoint(i, ofNode);
    branches->GetPoint(i, ofBranch);
    EXPECT_TRUE(std::equal(ofNode, ofNode + 3, ofBranch));
    EXPECT_EQ(value(run.nodes()->GetPointData(), "NodeId", i), i);
    EXPECT_EQ(value(run.nodes()->GetPointData(), "AtPlate", i), 0);
    EXPECT_EQ(value(run.nodes()->GetPointData(), "MaximumInscribedSphereRadius", i),
      value(branches->GetPointData(), "MaximumInscribedSphereRadius", i));
    vtkNew<vtkIdList> cells;
    branches->BuildLinks();
    branches->GetPointCells(i, cells);
    EXPECT_EQ(value(run.nodes()->GetPointData(), "Degree", i), cells->GetNumberOfIds());
  }
}

TEST(MedialCenterlines, CloseAroundARing)
{
  Tracing run(shapes::torus().samples);
  vtkPolyData* branches = run.branches();
  ASSERT_EQ(branches->GetNumberOfCells(), 1);
  EXPECT_EQ(run.nodes()->GetNumberOfPoints(), 0);
  vtkIdList* points = branches->GetCell(0)->GetPointIds();
  EXPECT_EQ(points->GetId(0), points->GetId(points->GetNumberOfIds() - 1));
  EXPECT_EQ(branches->GetNumberOfPoints() + 1, points->GetNumberOfIds());
  EXPECT_EQ(value(branches->GetCellData(), "BranchNodes", 0), -1);
}

TEST(MedialCenterlines, GoThroughPlatesOnRequest)
{
  Tracing run(shapes::twoHolePlate().samples);
  EXPECT_EQ(run.branches()->GetNumberOfCells(), 0);
  run.lines->SetWidthRatio(0);
  EXPECT_GE(run.branches()->GetNumberOfCells(), 2);
}

TEST(MedialCenterlines, AreTheSameOfAFile)
{
  Tracing run(treeSamples());
  vtkNew<vtkMedialCenterlines> again;
  run.stages.axis->Update();
  again->SetInputDataObject(filterTest::writtenAndRead(run.stages.axis->GetOutput()));
  again->Update();
  EXPECT_TRUE(filterTest::same(run.branches(), again->GetOutput()));
}

TEST(MedialCenterlines, RefuseAnAxisWithoutErosionThickness)
{
  Tracing run(treeSamples());
  run.stages.axis->Update();
  const auto axis = filterTest::copy<vtkPolyData>(run.stages.axis->GetOutput());
  axis->GetPointData()->RemoveArray("ErosionThickness");
  vtkNew<vtkMedialCenterlines> lines;
  lines->SetInputDataObject(axis);
  EXPECT_NE(filterTest::onlyError(lines).find("ErosionThickness"), std::string::npos);
  EXPECT_TRUE(filterTest::failed(lines));
}
}
