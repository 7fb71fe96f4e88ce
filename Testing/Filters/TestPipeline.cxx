// SPDX-License-Identifier: BSD-3-Clause
// From samples to a simplified surface, as users run it.
#include "FilterTest.h"

#include "vtkShareOutObjects.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>

namespace
{
using filterTest::cloud;
using filterTest::Pipeline;
using filterTest::same;
using filterTest::smallBox;
using filterTest::writtenAndRead;

using Numbers = std::array<double, 3>;

Numbers betti(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return { array->GetComponent(0, 0), array->GetComponent(0, 1), array->GetComponent(0, 2) };
}

double field(vtkDataObject* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

class PipelineOf : public testing::TestWithParam<shapes::Shape>
{
};

TEST_P(PipelineOf, KeepsTheTopologyAndClosesTheSurface)
{
  const shapes::Shape& shape = this->GetParam();
  const Numbers expected{ static_cast<double>(shape.betti[0]), static_cast<double>(shape.betti[1]),
    static_cast<double>(shape.betti[2]) };
  Pipeline pipeline(cloud(shape.samples));
  pipeline.crust->Update();
  EXPECT_EQ(betti(pipeline.balls->GetOutput(), "BettiPowerShape"), expected);
  EXPECT_EQ(betti(pipeline.axis->GetOutput(), "BettiAxis"), expected);
  EXPECT_EQ(betti(pipeline.prune->GetOutput(), "BettiAxis"), expected);
  EXPECT_EQ(betti(pipeline.crust->GetOutput(), "BettiCrust"), expected);
  EXPECT_EQ(field(pipeline.axis->GetOutput(), "Certificate"), 1);
  EXPECT_EQ(field(pipeline.crust->GetOutput(), "Closed"), 1);
  EXPECT_EQ(field(pipeline.crust->GetOutput(), "Manifold"), 1);
  EXPECT_NEAR(field(pipeline.crust->GetOutput(), "Volume"), shape.volume, 0.15 * shape.volume);
}

INSTANTIATE_TEST_SUITE_P(Shapes, PipelineOf,
  testing::Values(shapes::sphere(0.3), shapes::torus(0.25), shapes::hollowSphere(),
    shapes::twoObjects(0.2), shapes::box(0.15)),
  [](const testing::TestParamInfo<shapes::Shape>& info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

TEST(Pipeline, GivesTheSameThroughFilesAtEveryStage)
{
  Pipeline direct(cloud(smallBox().samples));
  direct.crust->Update();

  Pipeline resumed(writtenAndRead(cloud(smallBox().samples)));
  resumed.balls->Update();
  const auto balls = writtenAndRead(resumed.balls->GetOutput());
  resumed.axis->SetInputData(balls);
  resumed.axis->Update();
  resumed.parts->SetInputData(writtenAndRead(resumed.axis->GetOutput()));
  resumed.parts->Update();
  resumed.prune->SetInputData(writtenAndRead(resumed.parts->GetOutput()));
  resumed.prune->Update();
  resumed.crust->SetInputData(balls);
  resumed.crust->SetAxisData(writtenAndRead(resumed.prune->GetOutput()));
  resumed.crust->Update();
  EXPECT_TRUE(same(resumed.crust->GetOutput(), direct.crust->GetOutput()));
}

TEST(Pipeline, TakesItsOwnBallsHoweverFarAway)
{
  // Doubles near 1e12 are 1e-4 apart, and so are the centres of balls.
  for (const double distance : { 1e6, 1e9, 1e12 })
  {
    SCOPED_TRACE(distance);
    Pipeline pipeline(
      cloud(shapes::moved(shapes::sphere().samples, distance * medial::Point(1, -0.4, 0.7))));
    pipeline.crust->Update();
    EXPECT_EQ(betti(pipeline.crust->GetOutput(), "BettiCrust"), (Numbers{ 1, 0, 0 }));
  }
}

TEST(Pipeline, GivesTheSameTwice)
{
  Pipeline first(cloud(smallBox().samples)), second(cloud(smallBox().samples));
  first.crust->Update();
  second.crust->Update();
  EXPECT_TRUE(same(first.crust->GetOutput(), second.crust->GetOutput()));
  EXPECT_TRUE(same(first.prune->GetOutput(), second.prune->GetOutput()));
}

TEST(Pipeline, FollowsItsSamples)
{
  vtkSmartPointer<vtkPolyData> samples = cloud(shapes::sphere(0.4).samples);
  Pipeline pipeline(samples);
  pipeline.crust->Update();
  samples->SetPoints(cloud(smallBox().samples)->GetPoints());
  pipeline.crust->Update();
  EXPECT_TRUE(same(pipeline.crust->GetOutput(), filterTest::boxPipeline().crust->GetOutput()));
}

TEST(Pipeline, PrunesAgainWithoutMakingTheAxisAgain)
{
  Pipeline pipeline(cloud(smallBox().samples));
  pipeline.crust->Update();
  const vtkMTimeType made = pipeline.axis->GetOutput()->GetMTime();
  pipeline.prune->ClearIterations();
  pipeline.crust->Update();
  EXPECT_EQ(pipeline.axis->GetOutput()->GetMTime(), made);
}

TEST(Pipeline, FindsTheAxisOfEachBlock)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud(shapes::sphere(0.4).samples));
  blocks->SetBlock(1, cloud(smallBox().samples));
  Pipeline pipeline(blocks);
  pipeline.crust->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(pipeline.crust->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  EXPECT_TRUE(same(output->GetBlock(1), filterTest::boxPipeline().crust->GetOutput()));
  Pipeline sphere(cloud(shapes::sphere(0.4).samples));
  sphere.crust->Update();
  EXPECT_TRUE(same(output->GetBlock(0), sphere.crust->GetOutput()));
}

TEST(Pipeline, RefusesTheAxisOfAnotherBlock)
{
  vtkNew<vtkMultiBlockDataSet> axes;
  axes->SetBlock(0, filterTest::boxPipeline().prune->GetOutput());
  Pipeline sphere(cloud(shapes::sphere(0.4).samples));
  sphere.crust->SetAxisData(axes);
  sphere.balls->Update();
  EXPECT_NE(filterTest::onlyError(sphere.crust).find("no block of the axis"), std::string::npos);
}

TEST(Pipeline, NamesWhatIsWrongWithABlockOfTheAxis)
{
  const auto axis = filterTest::copy<vtkPolyData>(filterTest::boxPipeline().prune->GetOutput());
  vtkNew<vtkPoints> points; // of its own: nothing may be read beyond
  points->SetDataTypeToDouble();
  points->InsertPoints(0, 3, 0, axis->GetPoints());
  axis->SetPoints(points);
  vtkNew<vtkMultiBlockDataSet> axes;
  axes->SetBlock(0, axis);
  vtkNew<vtkPowerCrust> filter;
  filter->SetInputData(filterTest::boxPipeline().balls->GetOutput());
  filter->SetAxisData(axes);
  const std::string error = filterTest::onlyError(filter);
  EXPECT_NE(error.find("entries instead of 3"), std::string::npos) << error;
}

TEST(Pipeline, TellsBlocksApartThatDifferByTheirPlaceOnly)
{
  std::vector<medial::Point> moved = smallBox().samples;
  for (medial::Point& sample : moved)
  {
    sample += medial::Point(4, 0, 0);
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud(moved));
  blocks->SetBlock(1, cloud(smallBox().samples));
  Pipeline pipeline(blocks);
  pipeline.crust->Update();
  auto* axes = vtkMultiBlockDataSet::SafeDownCast(pipeline.prune->GetOutputDataObject(0));
  auto* output = vtkMultiBlockDataSet::SafeDownCast(pipeline.crust->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  EXPECT_TRUE(same(output->GetBlock(1), filterTest::boxPipeline().crust->GetOutput()));
  Pipeline first(cloud(moved));
  first.balls->Update();
  vtkNew<vtkMultiBlockDataSet> others;
  others->SetBlock(0, axes->GetBlock(1));
  first.crust->SetAxisData(others);
  EXPECT_NE(filterTest::onlyError(first.crust).find("no block of the axis"), std::string::npos);
  others->SetBlock(1, axes->GetBlock(0));
  first.crust->SetAxisData(others);
  first.crust->Update();
  EXPECT_TRUE(same(first.crust->GetOutput(), output->GetBlock(0)));
}

TEST(Pipeline, SharesOutAllObjectsWithoutRanks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud(shapes::sphere(0.4).samples));
  blocks->SetBlock(2, cloud(smallBox().samples));
  vtkNew<vtkShareOutObjects> shared;
  shared->SetInputDataObject(blocks);
  shared->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(shared->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  EXPECT_EQ(field(output->GetBlock(0), "ObjectId"), 0);
  EXPECT_FALSE(output->GetBlock(1));
  EXPECT_EQ(field(output->GetBlock(2), "ObjectId"), 2);
  EXPECT_EQ(blocks->GetBlock(0)->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST(Pipeline, TakesBlocksOneByOne)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud(smallBox().samples));
  blocks->SetBlock(1, cloud(shapes::sphere(0.4).samples));
  Pipeline pipeline(blocks);
  pipeline.prune->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(pipeline.prune->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  EXPECT_TRUE(same(output->GetBlock(0), filterTest::boxPipeline().prune->GetOutput()));
  EXPECT_GT(output->GetBlock(1)->GetNumberOfElements(vtkDataObject::CELL), 0);
}
}
