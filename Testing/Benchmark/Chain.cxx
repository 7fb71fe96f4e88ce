// SPDX-License-Identifier: BSD-3-Clause
// One run of the core's whole chain, stage by stage, and what it is measured by: CGAL's three triangulations
// of the same points. Prints JSON; benchmark.py beside this file runs it often and makes tables.

#include "Floor.h"
#include "Inputs.h"
#include "Stopwatch.h"

#include "Axis/SingularPoints.h"
#include "Balls/PowerShape.h"
#include "Crust/PowerCrust.h"
#include "Parts/BallShares.h"
#include "Pruning/Pruning.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace
{
using medial::Execution;
using medial::Index;
using medial::Point;

struct Step
{
  std::string name;
  Usage used;
};

/// Measures steps one after another.
class Steps
{
public:
  template <typename Work>
  auto run(const std::string& name, const Work& work)
  {
    const Usage before = usage();
    auto result = work();
    const Usage after = usage();
    this->list.push_back(
      { name, { after.cpu - before.cpu, after.wall - before.wall, after.memory } });
    return result;
  }

  std::vector<Step> list;
};

/// Numbers of a result, mixed into one: the same for the same result, bit for bit.
class Fingerprint
{
public:
  template <typename Value>
  Fingerprint& add(const std::vector<Value>& values)
  {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    for (std::size_t i = 0; i < values.size() * sizeof(Value); ++i)
    {
      this->hash = (this->hash ^ bytes[i]) * 0x100000001b3u;
    }
    return *this;
  }

  std::uint64_t value() const { return this->hash; }

private:
  std::uint64_t hash = 0xcbf29ce484222325u;
};

void onThreads(int threads, Index count, const Execution::Range& body)
{
  std::vector<std::thread> others;
  for (int t = 1; t < threads; ++t)
  {
    others.emplace_back([&, t] { body(count * t / threads, count * (t + 1) / threads); });
  }
  body(0, count / threads);
  for (std::thread& other : others)
  {
    other.join();
  }
}

/// With the default schedule but for the threshold of its last iteration.
medial::Pruned pruned(
  medial::PrunableAxis& axis, const std::string& last, const Execution& execution)
{
  medial::PruneOptions options;
  options.schedule = medial::parseSchedule("t5 t5 " + last);
  return medial::prune(axis, options, execution);
}

medial::Crust crustOf(
  const medial::PolarBalls& balls, const medial::MedialAxis& axis, const Execution& execution)
{
  medial::CrustOptions options;
  options.topology = axis.betti;
  return medial::powerCrust(balls, medial::keptBalls(axis), options, execution);
}

struct Run
{
  Steps floor, chain, again;
  Index samples = 0, balls = 0, sites = 0;
  std::size_t memoryBefore = 0;
  std::vector<medial::Betti> betti; ///< of power shape, axis, pruned axis, crust
  Fingerprint fingerprint;
};

void runFloor(const medial::PolarBalls& balls, Run& run)
{
  const std::vector<Point> sites =
    medial::singularPoints(balls, medial::powerShape(balls)).positions;
  run.sites = static_cast<Index>(sites.size());
  run.floor.run("Delaunay of samples", [&] { return floors::delaunay(balls.samples); });
  run.floor.run("regular of balls", [&] { return floors::regular(balls.balls); });
  run.floor.run("Delaunay of sites", [&] { return floors::delaunay(sites); });
}

Run runAll(const std::vector<Point>& samples, const Execution& execution)
{
  Run run;
  run.samples = static_cast<Index>(samples.size());
  forgetPeak();
  run.memoryBefore = usage().memory;
  const medial::PolarBallsAndSamples made =
    run.chain.run("balls", [&] { return medial::polarBallsAndSamples(samples, {}, execution); });
  const medial::PolarBalls& balls = made.balls;
  run.balls = static_cast<Index>(balls.balls.size());
  medial::MedialAxis axis =
    run.chain.run("axis", [&] { return medial::medialAxis(balls, {}, execution); });
  run.chain.run("parts", [&] { return medial::decompose(axis, 0, execution).parts.size(); });
  medial::Crust crust =
    run.chain.run("crust of all balls", [&] { return crustOf(balls, axis, execution); });
  run.betti = { axis.powerShapeBetti, axis.betti };
  run.fingerprint.add(axis.points).add(axis.cells.triangles).add(crust.points).add(crust.triangles);
  medial::PrunableAxis prunable(std::move(axis));
  const medial::Pruned one =
    run.chain.run("pruning", [&] { return pruned(prunable, "v1%", execution); });
  crust = run.chain.run("crust after pruning", [&] { return crustOf(balls, one.axis, execution); });
  run.betti.insert(run.betti.end(), { one.axis.betti, crust.betti });
  run.fingerprint.add(one.inputCell).add(crust.points).add(crust.triangles);
  run.again.run("other threshold", [&] {
    return crustOf(balls, pruned(prunable, "v2%", execution).axis, execution).triangles.size();
  });
  runFloor(balls, run);
  return run;
}

void print(const std::string& key, const Steps& steps)
{
  std::cout << ",\n \"" << key << "\": [";
  for (const Step& step : steps.list)
  {
    std::cout << (&step == &steps.list.front() ? "" : ",") << "\n  {\"name\": \"" << step.name
              << "\", \"cpu\": " << step.used.cpu << ", \"wall\": " << step.used.wall
              << ", \"memory\": " << step.used.memory << "}";
  }
  std::cout << "]";
}

void print(const Run& run)
{
  std::cout << "{\"samples\": " << run.samples << ", \"balls\": " << run.balls
            << ", \"sites\": " << run.sites << ", \"memory before\": " << run.memoryBefore
            << ",\n \"fingerprint\": \"" << std::hex << run.fingerprint.value() << std::dec
            << "\",\n \"betti\": [";
  for (const medial::Betti& betti : run.betti)
  {
    std::cout << (&betti == &run.betti.front() ? "[" : ", [") << betti[0] << ", " << betti[1]
              << ", " << betti[2] << "]";
  }
  std::cout << "]";
  print("floor", run.floor);
  print("chain", run.chain);
  print("again", run.again);
  std::cout << "}\n";
}

/// Coordinates as doubles, from standard input.
std::vector<Point> readSamples()
{
  std::vector<Point> result;
  Point point;
  while (std::cin.read(reinterpret_cast<char*>(point.data()), 3 * sizeof(double)))
  {
    result.push_back(point);
  }
  return result;
}

std::vector<Point> samplesOf(const std::string& name, Index count)
{
  for (const inputs::Input& input : inputs::all())
  {
    if (input.name == name)
    {
      return inputs::samples(input, count);
    }
  }
  throw medial::InvalidInput("there is no input named ", name);
}

int usageText()
{
  std::cerr << "usage: benchmark_chain INPUT COUNT [THREADS]   a made input\n"
               "       benchmark_chain - 0 [THREADS]         doubles x y z from standard input\n"
               "inputs:";
  for (const inputs::Input& input : inputs::all())
  {
    std::cerr << ' ' << input.name;
  }
  std::cerr << '\n';
  return 2;
}
}

int main(int argc, char** argv)
{
  if (argc < 3 || argc > 4)
  {
    return usageText();
  }
  try
  {
    const std::string name = argv[1];
    const int threads = argc > 3 ? std::atoi(argv[3]) : 1;
    Execution execution;
    if (threads > 1)
    {
      execution.parallelFor = [threads](Index count, const Execution::Range& body) {
        onThreads(threads, count, body);
      };
    }
    print(runAll(name == "-" ? readSamples() : samplesOf(name, std::atoi(argv[2])), execution));
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
