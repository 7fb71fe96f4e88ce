// SPDX-License-Identifier: BSD-3-Clause
// The schedule of vtkMedialPrune: in words, in texts, and what it refuses.
#include "MedialPruneTest.h"

#include <limits>
#include <string>

namespace
{
using filterTest::boxPipeline;
using filterTest::onlyError;
using medialPruneTest::history;
using medialPruneTest::pruneBox;

TEST(MedialPrune, RefusesThresholdsThatAreNegativeOrNoNumbers)
{
  for (const double threshold : { -1., std::numeric_limits<double>::quiet_NaN() })
  {
    vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
    filter->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, threshold);
    const std::string error = onlyError(filter);
    EXPECT_NE(error.find("threshold"), std::string::npos) << error;
  }
}

TEST(MedialPrune, RefusesWhatNoPartCanReach)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  const filterTest::ErrorLog log(filter);
  filter->AddIteration(vtkMedialPrune::RELATIVE_VOLUME, 5000);
  filter->AddIterationByName("ObjectAngle", 181);
  filter->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 5, -1);
  ASSERT_EQ(log.messages().size(), 3u);
  EXPECT_NE(log.messages()[0].find("no more than 100% of the volume"), std::string::npos);
  EXPECT_NE(log.messages()[1].find("above 180"), std::string::npos);
  EXPECT_NE(log.messages()[2].find("passes -1"), std::string::npos);
  EXPECT_EQ(filter->GetNumberOfIterations(), 0);
}

TEST(MedialPrune, TakesIterationsFromTexts)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->AddIterationFromText("RelativeVolume", "0.05", "2");
  EXPECT_EQ(filter->GetScheduleWords(), "v5%x2");
  EXPECT_EQ(vtkMedialPrune::GetIterationFault("RelativeVolume", "0.05", "2"), "");
  for (const char* threshold : { "0,05", "abc", "", "5000", "-1", "nan" })
  {
    vtkSmartPointer<vtkMedialPrune> other = pruneBox();
    const filterTest::ErrorLog log(other);
    other->AddIterationFromText("RelativeVolume", threshold, "0");
    ASSERT_EQ(log.messages().size(), 1u) << threshold;
    const std::string fault = vtkMedialPrune::GetIterationFault("RelativeVolume", threshold, "0");
    EXPECT_NE(fault.find("threshold"), std::string::npos) << fault;
    EXPECT_NE(log.messages()[0].find(fault), std::string::npos);
    EXPECT_EQ(other->GetNumberOfIterations(), 0);
    EXPECT_NE(onlyError(other).find(fault), std::string::npos);
  }
  EXPECT_NE(vtkMedialPrune::GetIterationFault(nullptr, nullptr, nullptr), "");
}

TEST(MedialPrune, RefusesAMeasureThatItDoesNotKnow)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  const filterTest::ErrorLog log(filter);
  filter->AddIteration(77, 5);
  ASSERT_EQ(log.messages().size(), 1u);
  EXPECT_NE(log.messages()[0].find("there is no measure 77"), std::string::npos);
  EXPECT_EQ(filter->GetNumberOfIterations(), 0);
}

TEST(MedialPrune, TakesASchedulesName)
{
  vtkNew<vtkMedialPrune> prune;
  int presets = 0;
  for (; vtkMedialPrune::GetPresetName(presets); ++presets)
  {
    prune->SetSchedule(vtkMedialPrune::GetPresetName(presets));
    EXPECT_EQ(prune->GetScheduleWords(), vtkMedialPrune::GetPresetWords(presets));
    EXPECT_NE(std::string(vtkMedialPrune::GetPresetDescription(presets)), "");
  }
  EXPECT_EQ(presets, 5);
  EXPECT_EQ(vtkMedialPrune::GetPresetName(-1), nullptr);
  EXPECT_EQ(vtkMedialPrune::GetPresetWords(presets), nullptr);
  prune->SetSchedule("noise");
  EXPECT_EQ(prune->GetScheduleWords(), vtkNew<vtkMedialPrune>()->GetScheduleWords());
}

TEST(MedialPrune, TakesAScheduleInWords)
{
  vtkNew<vtkMedialPrune> prune;
  EXPECT_EQ(prune->GetScheduleWords(), "t5 t5 h0.5s a2s");
  const vtkMTimeType before = prune->GetMTime();
  prune->SetSchedule("t5, t5 h0.5s a2s");
  EXPECT_EQ(prune->GetMTime(), before);
  prune->SetSchedule("a0.5x2 r3%");
  EXPECT_GT(prune->GetMTime(), before);
  ASSERT_EQ(prune->GetNumberOfIterations(), 2);
  EXPECT_EQ(prune->GetIterationMeasure(0), vtkMedialPrune::AREA);
  EXPECT_EQ(prune->GetIterationThreshold(0), 0.5);
  EXPECT_EQ(prune->GetIterationPasses(0), 2);
  EXPECT_EQ(prune->GetScheduleWords(), "a0.5x2 r3%");
  prune->SetSchedule(nullptr);
  EXPECT_EQ(prune->GetNumberOfIterations(), 0);
}

TEST(MedialPrune, DescribesEachMeasureAndNoOther)
{
  int measure = 0;
  for (; vtkMedialPrune::GetMeasureName(measure); ++measure)
  {
    EXPECT_NE(std::string(vtkMedialPrune::GetMeasureDescription(measure)), "");
    EXPECT_NE(vtkMedialPrune::GetMeasureWord(measure), "");
  }
  EXPECT_EQ(vtkMedialPrune::GetMeasureDescription(measure), nullptr);
  EXPECT_EQ(vtkMedialPrune::GetMeasureUnit(measure), nullptr);
  EXPECT_EQ(vtkMedialPrune::GetMeasureWord(measure), "");
}

TEST(MedialPrune, TellsTheWordsInItsHistory)
{
  vtkNew<vtkMedialPrune> prune;
  prune->SetInputConnection(boxPipeline().parts->GetOutputPort());
  prune->SetSchedule("t5 v0.01%x1");
  prune->AddCellToRemove(0);
  prune->Update();
  vtkTable* rows = history(prune);
  ASSERT_EQ(rows->GetNumberOfRows(), 3);
  EXPECT_EQ(rows->GetValueByName(0, "Word").ToString(), "t5");
  EXPECT_EQ(rows->GetValueByName(1, "Word").ToString(), "v0.01%");
  EXPECT_EQ(rows->GetValueByName(2, "Word").ToString(), "by hand");
}
}
