// SPDX-License-Identifier: BSD-3-Clause
// No stretch of work grows with the input: stages report the more often, the more there is to do. With
// argument --gtest_also_run_disabled_tests the longest stretches of a large input are printed.
#include "Numbers.h"
#include "Pipelines.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace
{
using medial::Execution;
using medial::Point;

/// All stages by their names, called with samples; body(stage, run) runs one.
void forStages(const std::vector<Point>& samples,
  const std::function<void(
    const std::string& stage, const std::function<void(const Execution&)>& run)>& body)
{
  medial::PolarBalls balls;
  medial::MedialAxis axis;
  medial::Pruned pruned;
  body("balls", [&](const Execution& e) { balls = medial::polarBalls(samples, e); });
  body("axis", [&](const Execution& e) { axis = medial::medialAxis(balls, {}, e); });
  body("parts", [&](const Execution& e) { medial::decompose(axis, 0, e); });
  body("unpruned crust", [&](const Execution& e) { medial::powerCrust(balls, {}, {}, e); });
  body("pruning",
    [&](const Execution& e) { pruned = medial::prune(axis, pipelines::standardSchedule(), e); });
  body("crust",
    [&](const Execution& e) { medial::powerCrust(balls, medial::keptBalls(pruned.axis), {}, e); });
}

std::vector<std::size_t> reportsOfStages(const std::vector<Point>& samples)
{
  std::vector<std::size_t> result;
  forStages(samples, [&](const std::string&, const std::function<void(const Execution&)>& run) {
    pipelines::Watch watch;
    run(watch.execution());
    result.push_back(watch.reports.size());
  });
  return result;
}

/// Samples of a torus with bumps, in no pattern.
std::vector<Point> bumpyTorus(double spacing)
{
  shapes::Random random(1);
  constexpr double turn = 2 * 3.14159265358979323846;
  const int around = static_cast<int>(2 * turn / spacing);
  const int across = static_cast<int>(0.7 * turn / spacing);
  std::vector<Point> result;
  for (int i = 0; i < around; ++i)
  {
    for (int k = 0; k < across; ++k)
    {
      const double u = turn * shapes::uniform(random, i, i + 1) / around;
      const double v = turn * shapes::uniform(random, k, k + 1) / across;
      const double r = 0.7 * (1 + 0.02 * shapes::sine(7 * u) * shapes::cosine(5 * v));
      const double width = 2 + r * shapes::cosine(v);
      result.emplace_back(width * shapes::cosine(u), width * shapes::sine(u), r * shapes::sine(v));
    }
  }
  return result;
}
}

TEST(Stages, ReportMoreOftenTheMoreThereIsToDo)
{
  const std::vector<std::size_t> few = reportsOfStages(bumpyTorus(0.15));
  const std::vector<std::size_t> many = reportsOfStages(bumpyTorus(0.06));
  for (std::size_t stage = 0; stage < few.size(); ++stage)
  {
    EXPECT_GE(few[stage], 4u) << stage;
    if (stage != 4) // pruning reports in each pass, and the number of passes follows from the shape
    {
      EXPECT_GE(many[stage], few[stage]) << stage;
    }
  }
  for (const std::size_t slow : { 0, 1, 3, 5 }) // balls, axis, crusts: where the time goes
  {
    EXPECT_GE(many[slow], 2 * few[slow]) << slow;
  }
}

TEST(Stages, DISABLED_ReportAtLeastOnceASecond)
{
  using Clock = std::chrono::steady_clock;
  const std::vector<Point> samples = bumpyTorus(0.0235);
  std::cout << samples.size() << " samples\n";
  forStages(
    samples, [](const std::string& stage, const std::function<void(const Execution&)>& run) {
      Clock::time_point last = Clock::now();
      std::chrono::duration<double> longest{ 0 };
      Execution execution;
      execution.progress = [&](double) {
        longest = std::max<std::chrono::duration<double>>(longest, Clock::now() - last);
        last = Clock::now();
        return true;
      };
      run(execution);
      execution.progress(1);
      std::cout << stage << ": at most " << longest.count() << " s without a report\n";
      EXPECT_LT(longest.count(), 1);
    });
}
