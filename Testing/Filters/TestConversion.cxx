// SPDX-License-Identifier: BSD-3-Clause
// What Conversion writes it reads back. (Compiled in: the library doesn't export it.)
#include "Conversion/Axis.h"
#include "Conversion/Balls.h"
#include "Conversion/Parts.h"
#include "Conversion/Verdict.h"
#include "Conversion/Warnings.h"

#include "FilterTest.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace
{
using filterTest::smallBox;

/// The core's values for the small box.
struct Values
{
  medial::PolarBallsAndSamples made = medial::polarBallsAndSamples(smallBox().samples);
  medial::MedialAxis axis = medial::medialAxis(this->made.balls);
  medial::MedialParts parts = medial::decompose(this->axis);
};

const Values& values()
{
  static const Values result;
  return result;
}

/// The balls of the small box as a data set.
vtkSmartPointer<vtkUnstructuredGrid> ballGrid()
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPolyData> samples;
  medial::write(values().made, filterTest::cloud(smallBox().samples), result, samples);
  return result;
}

vtkSmartPointer<vtkPolyData> axisData()
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  medial::write(values().axis, ballGrid(), result.GetPointer());
  return result;
}

bool sameBall(const medial::Ball& a, const medial::Ball& b)
{
  return a.center == b.center && a.radius == b.radius;
}

bool sameView(const medial::SiteView& a, const medial::SiteView& b)
{
  return a.objectAngle == b.objectAngle && a.lambda == b.lambda;
}

TEST(Conversion, ReadsSamplesInTheirOrder)
{
  EXPECT_EQ(medial::readSamples(filterTest::cloud(smallBox().samples)), smallBox().samples);
}

TEST(Conversion, ReadsThePolarBallsThatItWrote)
{
  const medial::PolarBalls& written = values().made.balls;
  const medial::PolarBalls read = medial::readPolarBalls(ballGrid());
  EXPECT_EQ(read.samples, written.samples);
  EXPECT_EQ(read.innerBall, written.innerBall);
  EXPECT_EQ(read.outerBall, written.outerBall);
  EXPECT_TRUE(std::equal(
    read.balls.begin(), read.balls.end(), written.balls.begin(), written.balls.end(), sameBall));
  EXPECT_EQ(read.sides, written.sides);
  EXPECT_EQ(read.touchesGuard, written.touchesGuard);
  EXPECT_EQ(read.volumes, written.volumes);
  EXPECT_EQ(read.poleVolumes, written.poleVolumes);
  EXPECT_EQ(read.ballSamples.offsets, written.ballSamples.offsets);
  EXPECT_EQ(read.ballSamples.items, written.ballSamples.items);
  EXPECT_EQ(read.spacing, written.spacing);
  EXPECT_EQ(read.triangulation.cells, written.triangulation.cells);
}

TEST(Conversion, ReadsTheMedialAxisThatItWrote)
{
  const medial::MedialAxis& written = values().axis;
  const medial::MedialAxis read = medial::readMedialAxis(axisData());
  EXPECT_EQ(read.points, written.points);
  EXPECT_EQ(read.radii, written.radii);
  EXPECT_EQ(read.ballOfPoint, written.ballOfPoint);
  EXPECT_EQ(read.cells.vertices, written.cells.vertices);
  EXPECT_EQ(read.cells.edges, written.cells.edges);
  EXPECT_EQ(read.cells.triangles, written.cells.triangles);
  EXPECT_EQ(read.polygonOfCell, written.polygonOfCell);
  EXPECT_EQ(read.samplesOfCell, written.samplesOfCell);
  EXPECT_TRUE(std::equal(read.siteViews.begin(), read.siteViews.end(), written.siteViews.begin(),
    written.siteViews.end(), sameView));
  EXPECT_EQ(read.ballOwner, written.ballOwner);
  EXPECT_EQ(read.ballVolumes, written.ballVolumes);
  EXPECT_EQ(read.poleVolumes, written.poleVolumes);
  EXPECT_EQ(read.erosion, written.erosion);
  EXPECT_EQ(read.cellErosion, written.cellErosion);
  EXPECT_EQ(read.powerShapeBetti, written.powerShapeBetti);
  EXPECT_EQ(read.betti, written.betti);
  EXPECT_EQ(read.certificate, written.certificate);
  EXPECT_EQ(read.fallback, written.fallback);
  EXPECT_EQ(read.kappa, written.kappa);
  EXPECT_EQ(read.filledGaps, written.filledGaps);
}

TEST(Conversion, TellsWhatToDoWithFilesOfAnEarlierVersion)
{
  for (const char* name : { "ObjectAngle", "Lambda", "ErosionThickness" })
  {
    const vtkSmartPointer<vtkPolyData> data = axisData();
    data->GetCellData()->RemoveArray(name);
    try
    {
      medial::readMedialAxis(data);
      ADD_FAILURE() << "an axis without " << name << " was read";
    }
    catch (const medial::InvalidInput& error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("there is no cell array '" + std::string(name)), std::string::npos);
      EXPECT_NE(message.find("earlier version"), std::string::npos) << message;
    }
  }
}

TEST(Conversion, ReadsVerticesEdgesAndTriangles)
{
  medial::MedialAxis axis = values().axis;
  axis.cells = { { 0, 5 }, { { 1, 2 } }, { { 2, 3, 4 }, { 2, 4, 6 } } };
  axis.polygonOfCell = { medial::None, medial::None, medial::None, 0, 0 };
  axis.samplesOfCell.assign(5, { medial::None, 7 });
  axis.cellErosion = { 0, 1, 2, 3, 4 };
  axis.siteViews = { { 180, 1 }, { 0, 0 }, { 120, 2 }, { 90, 3 }, { 60, 4 } };
  axis.betti = { 3, 0, 0 };
  axis.certificate = axis.betti == axis.powerShapeBetti;
  vtkNew<vtkPolyData> data;
  medial::write(axis, ballGrid(), data);
  EXPECT_EQ(data->GetCellType(0), VTK_VERTEX);
  EXPECT_EQ(data->GetCellType(2), VTK_LINE);
  EXPECT_EQ(data->GetCellType(4), VTK_TRIANGLE);
  const medial::MedialAxis read = medial::readMedialAxis(data);
  EXPECT_EQ(read.cells.vertices, axis.cells.vertices);
  EXPECT_EQ(read.cells.edges, axis.cells.edges);
  EXPECT_EQ(read.cells.triangles, axis.cells.triangles);
  EXPECT_EQ(read.polygonOfCell, axis.polygonOfCell);
}

TEST(Conversion, ReadsThePartsThatItWrote)
{
  vtkNew<vtkPolyData> parts, contacts;
  vtkNew<vtkTable> table;
  EXPECT_TRUE(medial::readParts(axisData()).empty());
  medial::write(values().parts, axisData(), parts, table, contacts);
  EXPECT_EQ(medial::readParts(parts), values().parts.partOfCell);
}

TEST(Conversion, FindsTheCellsOfParts)
{
  vtkNew<vtkPolyData> parts, contacts;
  vtkNew<vtkTable> table;
  medial::write(values().parts, axisData(), parts, table, contacts);
  const std::vector<medial::Index> cells = medial::readCells(parts, { 1 }, { 0 }, "removed");
  ASSERT_FALSE(cells.empty());
  EXPECT_EQ(cells.front(), 0);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(cells.size()) - 1,
    std::count(values().parts.partOfCell.begin(), values().parts.partOfCell.end(), 1));
}

bool sameWarning(const medial::Warning& a, const medial::Warning& b)
{
  return a.code == b.code && a.text == b.text && a.count == b.count && a.place == b.place &&
    a.doubtsSolid == b.doubtsSolid;
}

medial::Warnings madeUpWarnings()
{
  return { { "noise", "Noise, with \"<&>\" in it.", 5, medial::Point(0.1, -2, 1e300), true },
    { "open_surface", "It is open.", 0, {}, false } };
}

TEST(Conversion, ReadsTheWarningsThatItWrote)
{
  const medial::Warnings written = madeUpWarnings();
  const vtkSmartPointer<vtkPolyData> data = axisData();
  EXPECT_TRUE(medial::readWarnings(data->GetFieldData()).empty());
  medial::addWarnings(data->GetFieldData(), {});
  EXPECT_EQ(data->GetFieldData()->GetAbstractArray("WarningCode"), nullptr);
  medial::addWarnings(data->GetFieldData(), written);
  const vtkSmartPointer<vtkDataObject> fromFile = filterTest::writtenAndRead(data);
  for (vtkFieldData* field : { data->GetFieldData(), fromFile->GetFieldData() })
  {
    const medial::Warnings read = medial::readWarnings(field);
    EXPECT_TRUE(std::equal(read.begin(), read.end(), written.begin(), written.end(), sameWarning));
  }
}

TEST(Conversion, AddsWarningsToThoseThatAreThereOnce)
{
  const medial::Warnings first = madeUpWarnings();
  medial::Warnings more = first;
  more[1].count = 3;
  vtkNew<vtkFieldData> field;
  medial::addWarnings(field, first);
  medial::addWarnings(field, more);
  const medial::Warnings read = medial::readWarnings(field);
  ASSERT_EQ(read.size(), 3u);
  EXPECT_TRUE(sameWarning(read[0], first[0]));
  EXPECT_TRUE(sameWarning(read[1], first[1]));
  EXPECT_TRUE(sameWarning(read[2], more[1]));
}

TEST(Conversion, ReadsWhatTheStagesHaveFoundOut)
{
  const vtkSmartPointer<vtkUnstructuredGrid> balls = ballGrid();
  const vtkSmartPointer<vtkPolyData> axis = axisData();
  EXPECT_FALSE(medial::readFindings(balls, nullptr).axis);
  medial::addWarnings(axis->GetFieldData(), madeUpWarnings());
  const medial::Findings findings = medial::readFindings(balls, axis);
  EXPECT_EQ(findings.powerShape, (medial::Betti{ 1, 0, 0 }));
  ASSERT_TRUE(findings.axis);
  EXPECT_EQ(findings.axis->unpruned, values().axis.betti);
  EXPECT_TRUE(findings.axis->topologyKept);
  EXPECT_EQ(findings.warnings.size(), 2u);
}

TEST(Conversion, WritesAContactOfOnePointAsAVertex)
{
  medial::MedialParts made = values().parts;
  made.contacts = { { { 3, 4, 5 }, { 0, 1 } }, { { 7 }, { 0, 1, 2 } } };
  vtkNew<vtkPolyData> parts, contacts;
  vtkNew<vtkTable> table;
  medial::write(made, axisData(), parts, table, contacts);
  ASSERT_EQ(contacts->GetNumberOfCells(), 2);
  EXPECT_EQ(contacts->GetCellType(0), VTK_VERTEX);
  EXPECT_EQ(contacts->GetCellType(1), VTK_POLY_LINE);
  vtkDataArray* ids = contacts->GetCellData()->GetArray("ContactId");
  EXPECT_EQ(ids->GetComponent(0, 0), 1);
  EXPECT_EQ(ids->GetComponent(1, 0), 0);
}
}
