// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoundarySamples.h"

#include "FilterTest.h"
#include "Meshes.h"
#include "vtkPolarBalls.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
using filterTest::arrays;
using filterTest::dataOf;
using filterTest::ErrorLog;
using filterTest::isEmpty;
using filterTest::onlyError;
using filterTest::same;
using medial::Point;
using meshes::Mesh;

/// Outputs 2 and 3.
void expectBallsOfPolarBalls(vtkBoundarySamples* filter)
{
  vtkNew<vtkPolarBalls> balls;
  balls->SetInputConnection(filter->GetOutputPort(0));
  balls->SetSolidConnection(filter->GetOutputPort(1));
  balls->Update();
  EXPECT_TRUE(same(filter->GetOutputDataObject(2), balls->GetOutput()));
  EXPECT_TRUE(same(filter->GetOutputDataObject(3), balls->GetOutputDataObject(1)));
}

/// Few samples of a mesh.
vtkSmartPointer<vtkBoundarySamples> filterOf(const Mesh& mesh, double spacing = 0.2)
{
  auto result = vtkSmartPointer<vtkBoundarySamples>::New();
  result->SetInputData(dataOf(mesh));
  result->SetSpacing(spacing);
  return result;
}

vtkPolyData* surfaceOf(vtkBoundarySamples* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
}

double field(vtkDataObject* data, const char* name, int component = 0)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, component);
}

std::string text(vtkDataObject* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? array->GetValue(0) : std::string();
}

void expectBetti(vtkDataObject* data, const char* name, const medial::Betti& betti)
{
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(field(data, name, k), betti[k]) << name << " " << k;
  }
}

std::string refusal(const Mesh& mesh)
{
  return onlyError(filterOf(mesh));
}

TEST(BoundarySamples, HaveTheArraysOfTheirHeader)
{
  const auto filter = filterOf(meshes::torus());
  filter->Update();
  EXPECT_EQ(arrays(filter->GetOutput()->GetPointData()),
    (std::vector<std::string>{ "Normals float 3", "SourceCell idtype 1", "Spacing double 1" }));
  EXPECT_EQ(
    arrays(surfaceOf(filter)->GetCellData()), (std::vector<std::string>{ "SourceCell idtype 1" }));
  for (int port = 0; port < 2; ++port)
  {
    EXPECT_EQ(
      arrays(filter->GetOutputDataObject(port)->GetAttributesAsFieldData(vtkDataObject::FIELD)),
      (std::vector<std::string>{ "BettiSolid idtype 3", "DroppedPolygons idtype 1",
        "FilledHoles idtype 1", "MergedPoints idtype 1", "RefinementRounds idtype 1",
        "SolidArea double 1", "SolidVolume double 1" }));
    expectBetti(filter->GetOutputDataObject(port), "BettiSolid", { 1, 1, 0 });
  }
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "Spacing");
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetNormals()->GetName(), "Normals");
}

TEST(BoundarySamples, HaveTheBallsThatPolarBallsMakes)
{
  const auto filter = filterOf(meshes::iBeam(4), 0.3);
  filter->Update();
  expectBallsOfPolarBalls(filter);
  filter->SetMaximumRounds(0);
  filter->Update();
  expectBallsOfPolarBalls(filter);
  const auto few = filterOf(meshes::drilledPlate(0.02), 0.5); // with warnings
  few->AdaptiveOff();
  few->SetMaximumRounds(1);
  few->Update();
  EXPECT_EQ(text(few->GetOutputDataObject(2), "WarningCode"), "too_few_samples");
  expectBallsOfPolarBalls(few);
}

TEST(BoundarySamples, TellWhatTheSolidMeasures)
{
  const auto filter = filterOf(meshes::soup(meshes::box(Point::Zero(), Point(3, 2, 1))));
  filter->Update();
  EXPECT_NEAR(field(filter->GetOutput(), "SolidVolume"), 6, 1e-9);
  EXPECT_NEAR(field(filter->GetOutput(), "SolidArea"), 22, 1e-9);
  EXPECT_EQ(field(filter->GetOutput(), "MergedPoints"), 24 - 8);
  EXPECT_EQ(field(filter->GetOutput(), "DroppedPolygons"), 0);
  EXPECT_EQ(field(filter->GetOutput(), "FilledHoles"), 0);
  EXPECT_EQ(surfaceOf(filter)->GetNumberOfCells(), 12);
  EXPECT_EQ(surfaceOf(filter)->GetNumberOfPoints(), 8);
}

TEST(BoundarySamples, TellThePolygonThatTheyLieOn)
{
  const Mesh mesh = meshes::box(Point::Zero(), Point(3, 2, 1));
  const auto filter = filterOf(mesh);
  filter->Update();
  vtkPolyData* samples = filter->GetOutput();
  ASSERT_GT(samples->GetNumberOfPoints(), 200);
  ASSERT_EQ(samples->GetNumberOfCells(), samples->GetNumberOfPoints());
  vtkDataArray* cells = samples->GetPointData()->GetArray("SourceCell");
  vtkDataArray* normals = samples->GetPointData()->GetArray("Normals");
  EXPECT_GT(samples->GetPointData()->GetArray("Spacing")->GetRange()[0], 0);
  EXPECT_LE(samples->GetPointData()->GetArray("Spacing")->GetRange()[1], 0.2);
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    const Point normal(normals->GetTuple(i));
    const auto polygon = mesh.polygons[static_cast<medial::Index>(cells->GetComponent(i, 0))];
    EXPECT_NEAR(normal.dot(Point(samples->GetPoint(i)) - mesh.points[polygon[0]]), 0, 1e-12);
    EXPECT_EQ(normal.norm(), 1);
  }
}

TEST(BoundarySamples, PassFieldDataOnButNoVerdict)
{
  vtkSmartPointer<vtkPolyData> input = dataOf(meshes::torus());
  for (const char* name : { "Note", "Verdict" })
  {
    vtkNew<vtkStringArray> note;
    note->SetName(name);
    note->InsertNextValue("kept");
    input->GetFieldData()->AddArray(note);
  }
  vtkNew<vtkBoundarySamples> filter;
  filter->SetInputData(input);
  filter->SetSpacing(0.4);
  filter->Update();
  for (int port = 0; port < 2; ++port)
  {
    EXPECT_EQ(text(filter->GetOutputDataObject(port), "Note"), "kept");
    EXPECT_EQ(text(filter->GetOutputDataObject(port), "Verdict"), "");
  }
}

TEST(BoundarySamples, RefuseWhatBoundsNoSolid)
{
  const Mesh cube = meshes::box(Point::Zero(), Point::Ones());
  EXPECT_NE(refusal({ cube.points, {} }).find("no polygons"), std::string::npos);
  EXPECT_NE(refusal(meshes::without(cube, [](medial::Index i) { return i == 2; })).find("1 hole"),
    std::string::npos);
  EXPECT_NE(refusal(meshes::united(cube, meshes::moved(cube, Point(0.5, 0.4, 0.3))))
              .find("of separate pieces"),
    std::string::npos);
  Mesh bad = cube;
  bad.points[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(bad).find("not finite"), std::string::npos);
}

TEST(BoundarySamples, WrapWhatBoundsNoSolid)
{
  const Mesh cube = meshes::box(Point::Zero(), Point::Ones());
  const Mesh two = meshes::united(cube, meshes::moved(cube, Point(0.5, 0.4, 0.3)));
  const auto filter = filterOf(two);
  filter->WrapOn();
  filter->SetWrapWidth(0.2);
  filter->SetWrapOffset(0.02);
  const ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  ASSERT_EQ(log.messages().size(), 1u) << testing::PrintToString(log.messages());
  EXPECT_NE(log.messages()[0].find("about 0.02 outside"), std::string::npos);
  for (int port = 0; port < 2; ++port)
  {
    EXPECT_EQ(text(filter->GetOutputDataObject(port), "WarningCode"), "wrapped");
    expectBetti(filter->GetOutputDataObject(port), "BettiSolid", { 1, 0, 0 });
  }
  EXPECT_GT(field(surfaceOf(filter), "SolidVolume"), 1.79);
  filter->SetWrapWidth(-1);
  EXPECT_NE(onlyError(filter).find("width"), std::string::npos);
}

TEST(BoundarySamples, DontWrapWhatBoundsASolid)
{
  const auto filter = filterOf(meshes::box(Point::Zero(), Point::Ones()));
  filter->WrapOn();
  filter->Update();
  EXPECT_EQ(surfaceOf(filter)->GetNumberOfPoints(), 8);
  EXPECT_EQ(text(filter->GetOutput(), "WarningCode"), "");
}

TEST(BoundarySamples, RefusePropertiesOutOfRange)
{
  auto filter = filterOf(meshes::torus());
  filter->SetFineness(2);
  EXPECT_NE(onlyError(filter).find("fineness"), std::string::npos);
  filter = filterOf(meshes::torus(), -1);
  EXPECT_NE(onlyError(filter).find("spacing"), std::string::npos);
  filter = filterOf(meshes::torus());
  filter->SetMaximumSamples(3);
  EXPECT_NE(onlyError(filter).find("room for 4 samples"), std::string::npos);
  filter->SetMaximumSamples(vtkIdType(1) << 40); // more than an Index holds
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
}

TEST(BoundarySamples, WarnOfHolesThatWereFilledInBothOutputs)
{
  const Mesh mesh = meshes::without(
    meshes::triangulated(meshes::torus()), [](medial::Index i) { return i == 100; });
  const auto filter = filterOf(mesh);
  const ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  ASSERT_EQ(log.messages().size(), 1u) << testing::PrintToString(log.messages());
  EXPECT_NE(log.messages()[0].find("1 small hole"), std::string::npos);
  for (int port = 0; port < 2; ++port)
  {
    EXPECT_EQ(text(filter->GetOutputDataObject(port), "WarningCode"), "filled_holes");
    EXPECT_EQ(field(filter->GetOutputDataObject(port), "FilledHoles"), 1);
  }
  EXPECT_EQ(surfaceOf(filter)->GetCellData()->GetArray("SourceCell")->GetRange()[0], -1);
}

TEST(BoundarySamples, WarnOfTooManySamples)
{
  const auto filter = filterOf(meshes::drilledPlate(0.1));
  filter->SetMaximumSamples(1000);
  filter->SetMaximumRounds(0);
  const ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  EXPECT_EQ(log.messages().size(), 1u);
  EXPECT_EQ(text(filter->GetOutput(), "WarningCode"), "too_many_samples");
  EXPECT_LE(filter->GetOutput()->GetNumberOfPoints(), 1000);
}

TEST(BoundarySamples, AreTheSameForAnyThreadsAndFromAGrid)
{
  const auto filter = filterOf(meshes::torus());
  filter->Update();
  const auto again = filterOf(meshes::torus());
  vtkSMPTools::Initialize(1);
  again->Update();
  vtkSMPTools::Initialize(0);
  EXPECT_TRUE(same(again->GetOutput(), filter->GetOutput()));
  vtkNew<vtkUnstructuredGrid> grid;
  const auto data = dataOf(meshes::torus());
  grid->SetPoints(data->GetPoints());
  grid->SetCells(VTK_QUAD, data->GetPolys());
  again->SetInputData(grid);
  again->Update();
  EXPECT_TRUE(same(again->GetOutput(), filter->GetOutput()));
}

TEST(BoundarySamples, StopWithoutAnErrorAndRunAgain)
{
  const auto filter = filterOf(meshes::torus());
  vtkNew<vtkCallbackCommand> stopper;
  stopper->SetCallback([](vtkObject* sender, unsigned long, void*, void* done) {
    const double progress = *static_cast<double*>(done);
    if (progress > 0.3 && progress < 1)
    {
      static_cast<vtkAlgorithm*>(sender)->SetAbortExecute(1);
    }
  });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stopper);
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_TRUE(log.messages().empty()) << testing::PrintToString(log.messages());
  EXPECT_TRUE(isEmpty(filter->GetOutput()));
  EXPECT_TRUE(isEmpty(surfaceOf(filter)));
  filter->RemoveObserver(tag);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 100);
}

TEST(BoundarySamples, GiveEverythingInTheFirstPiece)
{
  const auto filter = filterOf(meshes::torus());
  filter->UpdatePiece(0, 2, 0);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 100);
  filter->UpdatePiece(1, 2, 0);
  EXPECT_TRUE(isEmpty(filter->GetOutput()));
  EXPECT_TRUE(isEmpty(surfaceOf(filter)));
}

/// The whole chain with the surface as the solid.
TEST(SolidOfBalls, IsComparedWithTheResult)
{
  const auto source = filterOf(meshes::torus());
  filterTest::Pipeline pipeline(nullptr);
  pipeline.balls->SetInputConnection(source->GetOutputPort());
  pipeline.balls->SetSolidConnection(source->GetOutputPort(1));
  pipeline.crust->Update();
  expectBetti(pipeline.balls->GetOutput(), "BettiSolid", { 1, 1, 0 });
  expectBetti(pipeline.balls->GetOutput(), "BettiPowerShape", { 1, 1, 0 });
  EXPECT_EQ(text(pipeline.crust->GetOutput(), "Verdict"), "certified");
}

TEST(SolidOfBalls, ThatIsAnotherOneIsNotCertified)
{
  const auto source = filterOf(meshes::torus());
  filterTest::Pipeline pipeline(nullptr);
  pipeline.balls->SetInputConnection(source->GetOutputPort());
  // The torus with a ball in its tunnel, which has no samples.
  pipeline.balls->SetSolidData(dataOf(meshes::united(meshes::torus(), meshes::sphere(0.4))));
  const ErrorLog log(pipeline.crust, vtkCommand::WarningEvent);
  pipeline.crust->Update();
  expectBetti(pipeline.balls->GetOutput(), "BettiSolid", { 2, 1, 0 });
  EXPECT_EQ(text(pipeline.crust->GetOutput(), "Verdict"), "not certified");
  EXPECT_NE(
    text(pipeline.crust->GetOutput(), "VerdictReasons").find("solid given"), std::string::npos)
    << text(pipeline.crust->GetOutput(), "VerdictReasons");
}

TEST(SolidOfBalls, IsRefusedIfItIsOpen)
{
  vtkNew<vtkPolarBalls> balls;
  balls->SetInputData(filterTest::cloud(filterTest::smallBox().samples));
  balls->SetSolidData(dataOf(meshes::without(
    meshes::box(Point::Zero(), Point::Ones()), [](medial::Index i) { return i == 0; })));
  EXPECT_NE(onlyError(balls).find("1 hole"), std::string::npos);
}
}
