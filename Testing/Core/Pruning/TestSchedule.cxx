// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Errors.h"
#include "Pruning/Schedule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using medial::allMeasures;
using medial::LengthUnit;
using medial::Measure;
using medial::MeasureTraits;
using medial::parseSchedule;
using medial::PruneIteration;
using medial::scheduleWords;
using medial::Unit;

namespace
{
using Schedule = std::vector<PruneIteration>;

/// What is said about words that can't be read.
std::string refusal(const std::string& words)
{
  try
  {
    parseSchedule(words);
  }
  catch (const medial::InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

/// What is said about an iteration in three texts that can't be read.
std::string refusal(
  const std::string& measure, const std::string& threshold, const std::string& passes = "0")
{
  try
  {
    medial::parseIteration(measure, threshold, passes);
  }
  catch (const medial::InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}

TEST(Schedule, IsReadWordByWord)
{
  EXPECT_EQ(parseSchedule("t5 t5 v1%"),
    (Schedule{ { Measure::TriangleCount, 5, 0 }, { Measure::TriangleCount, 5, 0 },
      { Measure::RelativeVolume, 0.01, 0 } }));
  EXPECT_EQ(parseSchedule(" t5,\tr2%\n r0.25x3, "),
    (Schedule{ { Measure::TriangleCount, 5, 0 },
      { Measure::MaximumRadius, 0.02, 0, LengthUnit::Diagonal },
      { Measure::MaximumRadius, 0.25, 3 } }));
  EXPECT_EQ(parseSchedule("v100% v0% a.5 o180"),
    (Schedule{ { Measure::RelativeVolume, 1, 0 }, { Measure::RelativeVolume, 0, 0 },
      { Measure::Area, 0.5, 0 }, { Measure::ObjectAngle, 180, 0 } }));
  EXPECT_TRUE(parseSchedule("").empty());
  EXPECT_TRUE(parseSchedule(" , ").empty());
}

TEST(Schedule, CountsLengthsInSpacings)
{
  EXPECT_EQ(parseSchedule("h1s e0.5sx2"),
    (Schedule{ { Measure::HausdorffDistance, 1, 0, LengthUnit::Spacing },
      { Measure::ErosionThickness, 0.5, 2, LengthUnit::Spacing } }));
  EXPECT_EQ(parseSchedule("a2s"), (Schedule{ { Measure::Area, 2, 0, LengthUnit::Spacing } }));
  EXPECT_EQ(scheduleWords(parseSchedule("a2s")), "a2s");
  for (const char* word : { "t5s", "v1s", "a2%", "o20s", "hs", "as", "h1%s", "h1ss" })
  {
    EXPECT_THROW(parseSchedule(word), medial::InvalidInput) << word;
  }
}

TEST(Schedule, HasPresets)
{
  for (const medial::SchedulePreset& preset : medial::schedulePresets())
  {
    EXPECT_EQ(parseSchedule(preset.name), parseSchedule(preset.words)) << preset.name;
    EXPECT_FALSE(parseSchedule(preset.words).empty()) << preset.name;
    EXPECT_THROW(parseSchedule(std::string("t5 ") + preset.name), medial::InvalidInput);
  }
  EXPECT_EQ(parseSchedule("noise"), parseSchedule(medial::defaultSchedule()));
}

TEST(Schedule, RoundsAPercentageOnce)
{
  EXPECT_EQ(parseSchedule("v0.1%")[0].threshold, 0.001);
  EXPECT_EQ(parseSchedule("v0.07%")[0].threshold, 0.0007);
  EXPECT_EQ(parseSchedule("v29%")[0].threshold, 0.29);
}

TEST(Schedule, IsWrittenInTheShortestWords)
{
  EXPECT_EQ(scheduleWords(parseSchedule("t5 t5 v1%")), "t5 t5 v1%");
  EXPECT_EQ(scheduleWords(parseSchedule("t005 v1.0% r2.50%x1 e.125")), "t5 v1% r2.5%x1 e0.125");
  EXPECT_EQ(scheduleWords({ { Measure::Area, 1e-7, 0 } }), "a0.0000001");
  EXPECT_EQ(scheduleWords({ { Measure::Area, 1e21, 0 } }), "a1" + std::string(21, '0'));
  EXPECT_EQ(scheduleWords({ { Measure::TriangleCount, 2.5, 0 } }), "t2");
  EXPECT_EQ(scheduleWords({}), "");
}

TEST(Schedule, IsTheSameAfterItWasWrittenAndRead)
{
  const unsigned seed = 17;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  const auto any = [&random] {
    const double number = random() / 4294967296.0;
    return std::ldexp(number, static_cast<int>(random() % 60) - 30);
  };
  Schedule schedule;
  for (int i = 0; i < 2000; ++i)
  {
    const MeasureTraits& traits = allMeasures()[random() % allMeasures().size()];
    PruneIteration iteration{ traits.measure, any(), static_cast<int>(random() % 3) };
    if (traits.unit == Unit::Length)
    {
      iteration.lengthUnit = static_cast<LengthUnit>(random() % 3);
    }
    if (traits.unit == Unit::Area && random() % 2 == 0)
    {
      iteration.lengthUnit = LengthUnit::Spacing;
    }
    if (traits.unit == Unit::Count)
    {
      iteration.threshold = std::floor(iteration.threshold);
    }
    if (traits.unit == Unit::Share || traits.unit == Unit::Degrees)
    {
      iteration.threshold = random() / 4294967296.0 * medial::largestThreshold(traits.unit);
    }
    schedule.push_back(iteration);
  }
  EXPECT_EQ(parseSchedule(scheduleWords(schedule)), schedule);
}

TEST(Schedule, HasShortWordsForPeople)
{
  EXPECT_EQ(medial::shortWord({ Measure::RelativeVolume, 0.0123456, 0 }), "v1.23%");
  EXPECT_EQ(medial::shortWord({ Measure::RelativeVolume, 0.01, 1 }), "v1%x1");
  EXPECT_EQ(medial::shortWord({ Measure::Area, 123456, 0 }), "a123000");
  EXPECT_EQ(medial::shortWord({ Measure::MaximumRadius, 0.02, 0, LengthUnit::Diagonal }), "r2%");
}

TEST(Schedule, HasAWordForEveryMeasure)
{
  for (const MeasureTraits& traits : allMeasures())
  {
    const std::string pattern = medial::wordPattern(traits);
    const bool isShare = traits.unit == Unit::Share;
    const Schedule read = parseSchedule(pattern.substr(0, 1) + "1" + (isShare ? "%" : ""));
    ASSERT_EQ(read.size(), 1u) << traits.name;
    EXPECT_EQ(read[0].measure, traits.measure);
    EXPECT_EQ(read[0].threshold, isShare ? 0.01 : 1);
  }
}

TEST(Schedule, PointsAtTheWordThatIsWrong)
{
  const std::string text = refusal("t5 x3 v1%");
  EXPECT_TRUE(contains(text, "word 2 of the schedule, 'x3'")) << text;
  for (const MeasureTraits& traits : allMeasures())
  {
    EXPECT_TRUE(contains(text, medial::wordPattern(traits))) << text;
  }
  EXPECT_TRUE(contains(text, "no measure has the letter x")) << text;
  EXPECT_TRUE(contains(refusal("v0.01"), "written in per cent"));
  EXPECT_TRUE(contains(refusal("v101%"), "no more than 100%"));
  EXPECT_TRUE(contains(refusal("t1.5"), "whole number"));
  EXPECT_TRUE(contains(refusal("t5%"), "the unit count is not written in per cent"));
  EXPECT_TRUE(contains(refusal("a1%"), "the unit area is not written in per cent"));
  EXPECT_TRUE(contains(refusal("t"), "no threshold"));
  EXPECT_TRUE(contains(refusal("t5x"), "number of passes"));
  EXPECT_TRUE(contains(refusal("t5x0"), "number of passes"));
}

TEST(Schedule, RefusesWhatIsNoPlainNumber)
{
  for (const char* word : { "t-1", "v1e1%", "v1%%", "v%", "r", "r-1", "r1.2.3", "r.", "rnan",
         "rinf", "t5x-1", "t5x1.5", "T5", "5t", "%", "t5x2147483648" })
  {
    EXPECT_TRUE(contains(refusal(word), "'" + std::string(word) + "'")) << word;
  }
}

TEST(Schedule, ReadsAnIterationFromThreeTexts)
{
  for (const MeasureTraits& traits : allMeasures())
  {
    EXPECT_EQ(medial::parseIteration(traits.name, " 0.05 ", "2"),
      (PruneIteration{ traits.measure, 0.05, 2 }));
    EXPECT_EQ(medial::parseIteration(traits.name, "5e-2", "0"),
      (PruneIteration{ traits.measure, 0.05, 0 }));
  }
}

TEST(Schedule, ReadsLengthsInSpacingsFromText)
{
  EXPECT_EQ(medial::parseIteration("HausdorffDistance", " 1.5s ", "0"),
    (PruneIteration{ Measure::HausdorffDistance, 1.5, 0, LengthUnit::Spacing }));
  EXPECT_EQ(medial::parseIteration("Lambda", "0.07%", "1"),
    (PruneIteration{ Measure::Lambda, 0.0007, 1, LengthUnit::Diagonal }));
  for (const char* threshold : { "s", "%", "1 s", "1ss", "1%s", "1e-2%", "infs" })
  {
    EXPECT_TRUE(contains(refusal("HausdorffDistance", threshold), "threshold")) << threshold;
  }
  EXPECT_TRUE(contains(refusal("TriangleCount", "5s"), "threshold"));
  EXPECT_TRUE(contains(refusal("RelativeVolume", "5%"), "threshold"));
}

TEST(Schedule, NeverTakesATextForAnotherNumber)
{
  for (const MeasureTraits& traits : allMeasures())
  {
    for (const char* threshold : { "0,05", "abc", "", " ", "5 %", "1.2.3", "1,000", "0x10", "5t",
           "nan", "inf", "-inf", "-1", "-1e-300", "1e400" })
    {
      const std::string text = refusal(traits.name, threshold);
      EXPECT_TRUE(contains(text, "threshold")) << traits.name << threshold << text;
      EXPECT_TRUE(contains(text, traits.name)) << text;
    }
    for (const char* passes : { "", "abc", "-1", "1.5", "1,5", "2147483648", "0x1", "nan" })
    {
      EXPECT_TRUE(contains(refusal(traits.name, "0.5", passes), "number of passes")) << passes;
    }
  }
  EXPECT_TRUE(contains(refusal("RelativeVolume", "0,05"), "0.05"));
  EXPECT_TRUE(contains(refusal("Beauty", "5"), "no measure 'Beauty'"));
}

TEST(Schedule, RefusesThresholdsAboveAllValues)
{
  for (const MeasureTraits& traits : allMeasures())
  {
    const double largest = medial::largestThreshold(traits.unit);
    const PruneIteration all{ traits.measure, largest, 0 };
    EXPECT_EQ(medial::faultOf(all), "");
    const bool isLimited = traits.unit == Unit::Share || traits.unit == Unit::Degrees;
    EXPECT_EQ(isLimited, largest < 1e9) << traits.name;
    for (const double above : { std::nextafter(largest, 1e9), 5000. })
    {
      const bool isRefused = !medial::faultOf({ traits.measure, above, 0 }).empty();
      EXPECT_EQ(isRefused, isLimited) << traits.name << above;
    }
  }
  EXPECT_TRUE(contains(refusal("RelativeVolume", "5000"), "'5000'"));
  EXPECT_TRUE(contains(refusal("RelativeVolume", "5000"), "no more than 100% of the volume"));
  EXPECT_TRUE(contains(refusal("o181"), "is above 180"));
}
