// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <limits>

namespace
{
using filterTest::arrays;
using filterTest::boxPipeline;
using filterTest::cloud;
using filterTest::onlyError;
using filterTest::smallBox;
using medial::Point;

double field(vtkDataObject* data, const char* name, vtkIdType entry = 0, int component = 0)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(entry, component);
}

vtkPolyData* samplesOf(vtkPolarBalls* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
}

/// Says to what the coordinates of the samples were rounded.
void setResolution(vtkPolyData* samples, double value)
{
  vtkNew<vtkDoubleArray> unit;
  unit->SetName("SampleResolution");
  unit->InsertNextValue(value);
  samples->GetFieldData()->AddArray(unit);
}

/// Each sample of a small box twice.
/// @param type      of the coordinates
/// @param place     where the box is
/// @param distance  of the two along x
vtkSmartPointer<vtkPolyData> twice(double distance, int type = VTK_DOUBLE, double place = 0)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (const double x : { place, place + distance })
  {
    for (const Point& sample : smallBox().samples)
    {
      points->InsertNextPoint(sample.x() + x, sample.y(), sample.z());
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  return result;
}

double duplicates(vtkPolyData* samples, double tolerance = -1)
{
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(samples);
  filter->SetMergeTolerance(tolerance);
  filter->Update();
  EXPECT_EQ(filter->GetMergeTolerance(), tolerance);
  return field(filter->GetOutput(), "NumberOfDuplicates");
}

/// What the filter says about samples that it can't use.
std::string refusal(const std::vector<Point>& samples)
{
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(cloud(samples));
  return onlyError(filter);
}

TEST(PolarBalls, HaveTheArraysOfTheirHeader)
{
  vtkUnstructuredGrid* balls = boxPipeline().balls->GetOutput();
  EXPECT_EQ(arrays(balls->GetPointData()),
    (std::vector<std::string>{ "InnerRadius double 1", "PoleVolume double 1", "Radius double 1",
      "Side unsigned char 1", "TouchesGuard unsigned char 1", "Volume double 1" }));
  EXPECT_EQ(arrays(balls->GetFieldData()),
    (std::vector<std::string>{ "BallSampleOffsets idtype 1", "BallSamples idtype 1",
      "BettiPowerShape idtype 3", "MergeTolerance double 1", "NumberOfDuplicates idtype 1",
      "NumberOfHiddenBalls idtype 1", "NumberOfInnerBalls idtype 1", "NumberOfOuterBalls idtype 1",
      "NumberOfSamples idtype 1", "SampleInnerBall idtype 1", "SampleOuterBall idtype 1",
      "SampleSpacing double 1", "Samples double 3" }));
}

TEST(PolarBalls, HaveSamplesWithTheArraysOfTheirHeader)
{
  vtkPolyData* samples = samplesOf(boxPipeline().balls);
  EXPECT_EQ(arrays(samples->GetPointData()),
    (std::vector<std::string>{ "DuplicateOf idtype 1", "InnerBall idtype 1", "OuterBall idtype 1",
      "SamplingQuality double 1" }));
  EXPECT_EQ(arrays(samples->GetCellData()), std::vector<std::string>());
  EXPECT_EQ(arrays(samples->GetFieldData()), std::vector<std::string>());
  EXPECT_STREQ(samples->GetPointData()->GetScalars()->GetName(), "SamplingQuality");
  EXPECT_EQ(samples->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST(PolarBalls, HaveAVertexForEachSampleInTheOrderGiven)
{
  vtkPolyData* samples = samplesOf(boxPipeline().balls);
  const std::vector<Point>& given = smallBox().samples;
  ASSERT_EQ(samples->GetNumberOfPoints(), static_cast<vtkIdType>(given.size()));
  ASSERT_EQ(samples->GetNumberOfCells(), samples->GetNumberOfPoints());
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(Point(samples->GetPoint(i)), given[static_cast<std::size_t>(i)]);
    ASSERT_EQ(samples->GetCellType(i), VTK_VERTEX);
    EXPECT_EQ(samples->GetCell(i)->GetPointId(0), i);
  }
}

TEST(PolarBalls, TellTheQualityOfTheirSamples)
{
  vtkDataArray* quality = samplesOf(boxPipeline().balls)->GetPointData()->GetScalars();
  EXPECT_GE(quality->GetRange()[0], -1);
  EXPECT_LT(quality->GetRange()[0], 0.5); // at an edge of the box
  EXPECT_LE(quality->GetRange()[1], 1);
  EXPECT_GT(quality->GetRange()[1], 0.9); // on a face
}

TEST(PolarBalls, TellTheTwoBallsOfTheirSamples)
{
  vtkUnstructuredGrid* balls = boxPipeline().balls->GetOutput();
  vtkPolyData* samples = samplesOf(boxPipeline().balls);
  vtkDataArray* sides = balls->GetPointData()->GetArray("Side");
  vtkDataArray* radii = balls->GetPointData()->GetArray("Radius");
  for (const bool inner : { false, true })
  {
    vtkDataArray* ids = samples->GetPointData()->GetArray(inner ? "InnerBall" : "OuterBall");
    const char* same = inner ? "SampleInnerBall" : "SampleOuterBall";
    vtkIdType found = 0;
    for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
    {
      const auto ball = static_cast<vtkIdType>(ids->GetComponent(i, 0));
      ASSERT_EQ(field(balls, same, i), static_cast<double>(ball));
      ASSERT_GE(ball, -1);
      ASSERT_LT(ball, balls->GetNumberOfPoints());
      if (ball >= 0)
      {
        const double radius = radii->GetComponent(ball, 0);
        const double distance = (Point(balls->GetPoint(ball)) - Point(samples->GetPoint(i))).norm();
        EXPECT_EQ(sides->GetComponent(ball, 0), inner);
        EXPECT_NEAR(distance, radius, 1e-8 * (1 + radius));
        ++found;
      }
    }
    EXPECT_GT(found, samples->GetNumberOfPoints() / 2);
  }
}

TEST(PolarBalls, PassFieldDataOnToTheirSamples)
{
  vtkSmartPointer<vtkPolyData> given = cloud(smallBox().samples);
  vtkNew<vtkStringArray> note;
  note->SetName("Note");
  note->InsertNextValue("kept");
  given->GetFieldData()->AddArray(note);
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(given);
  filter->Update();
  EXPECT_EQ(samplesOf(filter)->GetFieldData()->GetAbstractArray("Note"), note);
}

TEST(PolarBalls, AreDoubles)
{
  EXPECT_EQ(boxPipeline().balls->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST(PolarBalls, ListTheSamplesInTheOrderGiven)
{
  vtkUnstructuredGrid* balls = boxPipeline().balls->GetOutput();
  const std::vector<Point>& samples = smallBox().samples;
  ASSERT_EQ(field(balls, "NumberOfSamples"), static_cast<double>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(field(balls, "Samples", static_cast<vtkIdType>(i), axis), samples[i][axis]);
    }
  }
}

TEST(PolarBalls, TouchTheirSamples)
{
  vtkUnstructuredGrid* balls = boxPipeline().balls->GetOutput();
  vtkDataArray* radii = balls->GetPointData()->GetArray("Radius");
  for (vtkIdType ball = 0; ball < balls->GetNumberOfPoints(); ++ball)
  {
    const Point center(balls->GetPoint(ball));
    const double radius = radii->GetComponent(ball, 0);
    for (double i = field(balls, "BallSampleOffsets", ball);
         i < field(balls, "BallSampleOffsets", ball + 1); ++i)
    {
      const auto sample =
        static_cast<std::size_t>(field(balls, "BallSamples", static_cast<vtkIdType>(i)));
      EXPECT_NEAR((smallBox().samples[sample] - center).norm(), radius, 1e-8 * (1 + radius));
    }
  }
}

TEST(PolarBalls, AreCountedBySide)
{
  vtkUnstructuredGrid* balls = boxPipeline().balls->GetOutput();
  vtkDataArray* sides = balls->GetPointData()->GetArray("Side");
  std::array<double, 3> counts{};
  for (vtkIdType ball = 0; ball < balls->GetNumberOfPoints(); ++ball)
  {
    ++counts.at(static_cast<std::size_t>(sides->GetComponent(ball, 0)));
  }
  EXPECT_EQ(counts[0], field(balls, "NumberOfOuterBalls"));
  EXPECT_EQ(counts[1], field(balls, "NumberOfInnerBalls"));
  EXPECT_EQ(counts[2], field(balls, "NumberOfHiddenBalls"));
  EXPECT_GT(counts[0], 0);
  EXPECT_GT(counts[1], 0);
}

TEST(PolarBalls, KnowTheBettiNumbersOfTheSolid)
{
  filterTest::Pipeline pipeline(cloud(shapes::torus(0.3).samples));
  pipeline.balls->Update();
  vtkDataObject* balls = pipeline.balls->GetOutput();
  EXPECT_EQ(field(balls, "BettiPowerShape", 0, 0), 1);
  EXPECT_EQ(field(balls, "BettiPowerShape", 0, 1), 1);
  EXPECT_EQ(field(balls, "BettiPowerShape", 0, 2), 0);
}

TEST(PolarBalls, TakeRepeatedPointsOnce)
{
  std::vector<Point> samples = smallBox().samples;
  samples.insert(samples.end(), samples.begin(), samples.begin() + 10);
  filterTest::Pipeline pipeline(cloud(samples));
  pipeline.balls->Update();
  vtkUnstructuredGrid* balls = pipeline.balls->GetOutput();
  EXPECT_EQ(balls->GetNumberOfPoints(), boxPipeline().balls->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(field(balls, "NumberOfDuplicates"), 10);
  vtkPolyData* output = samplesOf(pipeline.balls);
  ASSERT_EQ(output->GetNumberOfPoints(), static_cast<vtkIdType>(samples.size()));
  const vtkIdType repeated = output->GetNumberOfPoints() - 1;
  for (const char* name : { "SamplingQuality", "InnerBall", "OuterBall" })
  {
    vtkDataArray* values = output->GetPointData()->GetArray(name);
    EXPECT_EQ(values->GetComponent(repeated, 0), values->GetComponent(9, 0)) << name;
  }
  vtkDataArray* first = output->GetPointData()->GetArray("DuplicateOf");
  EXPECT_EQ(first->GetComponent(repeated, 0), 9);
  EXPECT_EQ(first->GetComponent(9, 0), -1);
}

TEST(PolarBalls, TakeSamplesThatWereRoundedApartForOne)
{
  const double all = static_cast<double>(smallBox().samples.size());
  const double near = 3e-3; // in spacings 0.025, too much for copies that nothing tells of
  EXPECT_EQ(duplicates(twice(near)), 0);
  EXPECT_EQ(duplicates(twice(near), 2 * near), all);
  EXPECT_EQ(duplicates(twice(1e-8)), all);
  EXPECT_EQ(duplicates(twice(1e-8), 0), 0);
  const vtkSmartPointer<vtkPolyData> text = twice(near);
  setResolution(text, near);
  EXPECT_EQ(duplicates(text), all);
  // Floats from 32768 on are 2^-8 apart.
  EXPECT_EQ(duplicates(twice(std::ldexp(1, -8), VTK_FLOAT, 32768)), all);
  EXPECT_EQ(duplicates(twice(std::ldexp(1, -6), VTK_FLOAT, 32768)), 0);
  EXPECT_EQ(duplicates(twice(std::ldexp(1, -8), VTK_DOUBLE, 32768)), 0);
}

TEST(PolarBalls, KeepTheUnitOfTheirSamplesToThemselves)
{
  const vtkSmartPointer<vtkPolyData> input = twice(1e-4);
  setResolution(input, 1e-4);
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(input);
  filter->Update();
  EXPECT_EQ(field(filter->GetOutput(), "MergeTolerance"), 2e-4);
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("SampleResolution"));
  EXPECT_FALSE(samplesOf(filter)->GetFieldData()->HasArray("SampleResolution"));
}

TEST(PolarBalls, RefuseAUnitOfTheSamplesThatIsNoLength)
{
  for (const double value : { -1.0, std::numeric_limits<double>::infinity() })
  {
    const vtkSmartPointer<vtkPolyData> input = twice(1e-4);
    setResolution(input, value);
    vtkNew<vtkPolarBalls> filter;
    filter->SetInputData(input);
    EXPECT_NE(onlyError(filter).find("'SampleResolution' must hold one length"), std::string::npos);
  }
}

TEST(PolarBalls, DontDependOnCells)
{
  vtkSmartPointer<vtkPolyData> samples = cloud(smallBox().samples);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  samples->SetPolys(cells);
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(samples);
  const filterTest::ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  EXPECT_EQ(log.messages().size(), 1u); // an open surface
  for (const char* array : { "WarningCode", "WarningText", "WarningCount", "WarningPlace",
         "WarningHasPlace", "WarningDoubtsSolid" })
  {
    filter->GetOutput()->GetFieldData()->RemoveArray(array);
  }
  EXPECT_TRUE(filterTest::same(filter->GetOutput(), boxPipeline().balls->GetOutput()));
}

TEST(PolarBalls, TakeAnyPointSet)
{
  vtkNew<vtkUnstructuredGrid> samples;
  samples->SetPoints(cloud(smallBox().samples)->GetPoints());
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(samples);
  filter->Update();
  EXPECT_TRUE(filterTest::same(filter->GetOutput(), boxPipeline().balls->GetOutput()));
}

TEST(PolarBalls, RefuseNoPoints)
{
  EXPECT_NE(refusal({}).find("no samples"), std::string::npos);
}

TEST(PolarBalls, RefuseADataSetThatNeverHadPoints)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(nothing);
  EXPECT_NE(onlyError(filter).find("no samples"), std::string::npos);
}

TEST(PolarBalls, RefuseThreePoints)
{
  EXPECT_NE(refusal({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 1, 0 } })
              .find("at least 4 points of a closed surface are needed"),
    std::string::npos);
}

TEST(PolarBalls, RefusePointsOnALine)
{
  EXPECT_NE(refusal({ { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 }, { 4, 4, 4 } })
              .find("on one line"),
    std::string::npos);
}

TEST(PolarBalls, RefusePointsInAPlane)
{
  EXPECT_NE(refusal({ { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 }, { 3, 2, 1 }, { 1, 5, 1 } })
              .find("in one plane"),
    std::string::npos);
}

TEST(PolarBalls, RefuseCoordinatesThatAreNotFinite)
{
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    std::vector<Point> samples = smallBox().samples;
    samples[7].y() = bad;
    const std::string error = refusal(samples);
    EXPECT_NE(error.find("sample 7 has a coordinate that is not finite"), std::string::npos);
    EXPECT_NE(error.find("remove such points"), std::string::npos);
  }
}

TEST(PolarBalls, ForgetAnErrorOnceTheInputIsGood)
{
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(cloud({}));
  onlyError(filter);
  filter->SetInputData(cloud(smallBox().samples));
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_TRUE(filterTest::same(filter->GetOutput(), boxPipeline().balls->GetOutput()));
}

TEST(PolarBalls, DontRunOnAnImage)
{
  vtkNew<vtkImageData> image;
  vtkNew<vtkPolarBalls> filter;
  const filterTest::ErrorLog log(filter);
  filter->SetInputDataObject(image);
  EXPECT_EQ(filter->GetExecutive()->Update(), 0);
  EXPECT_TRUE(filterTest::isEmpty(filter->GetOutput()));
}
}
