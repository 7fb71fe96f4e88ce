// SPDX-License-Identifier: BSD-3-Clause
// Changes outputs of the stages at random, as a damaged file or a mistaken program would, and runs the
// stages that read them.
//
//   fuzz_stages [--count N] [--seed S] [--verbose]
//
// Seed S + i makes change i, the same on every machine. A fault is a crash, more than ten seconds of work,
// VTK complaining itself, an error with an output, or an output without an error that makes no sense; see
// StageChain.h for what does. Each fault is printed with its seed: --seed S --count 1 --verbose shows it.
#include "Mutations.h"
#include "Numbers.h"
#include "Shapes.h"
#include "StageChain.h"

#include <vtkLogger.h>
#include <vtkPointSet.h>
#include <vtkSMPTools.h>

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using fuzz::Random;
using fuzz::Stages;

/// Ends the process after ten seconds of work, however busy the machine is, and if it waits for ever.
void limitTime()
{
  itimerval limit{};
  limit.it_value.tv_sec = 10;
  setitimer(ITIMER_PROF, &limit, nullptr);
  alarm(600);
}

struct Options
{
  unsigned count = 1000, seed = 1;
  bool verbose = false;
};

Options optionsOf(int argc, char** argv)
{
  Options result;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    const bool hasNumber = i + 1 < argc;
    if (name == "--verbose")
    {
      result.verbose = true;
    }
    else if (hasNumber && (name == "--count" || name == "--seed"))
    {
      (name == "--count" ? result.count : result.seed) =
        static_cast<unsigned>(std::strtoul(argv[++i], nullptr, 10));
    }
    else
    {
      throw std::invalid_argument("usage: fuzz_stages [--count N] [--seed S] [--verbose]");
    }
  }
  return result;
}

/// Rings of eight samples about a line: the axis is a string of lines.
std::vector<medial::Point> rings()
{
  constexpr double pi = 3.14159265358979323846;
  std::vector<medial::Point> result{ { 0, 0, -0.2 }, { 0, 0, 5.4 } };
  for (int ring = 0; ring <= 26; ++ring)
  {
    const double radius = ring == 0 || ring == 26 ? 0.15 : 0.3 + 0.02 * (ring % 4);
    for (int k = 0; k < 8; ++k)
    {
      const double angle = (k + 0.5 * (ring % 2)) * pi / 4;
      result.emplace_back(radius * shapes::cosine(angle), radius * shapes::sine(angle), 0.2 * ring);
    }
  }
  return result;
}

std::vector<Stages> allStages()
{
  return { fuzz::stagesOf("box", shapes::box(0.45).samples),
    fuzz::stagesOf("torus", shapes::torus(0.5).samples),
    fuzz::stagesOf("hollow sphere", shapes::hollowSphere(0.28).samples),
    fuzz::stagesOf("two objects", shapes::twoObjects(0.4).samples),
    fuzz::stagesOf("string", rings()) };
}

/// One to three changes of one output of one object, and what comes of them.
bool isRight(const std::vector<Stages>& all, unsigned seed, bool verbose)
{
  Random random(seed);
  Stages stages = all[static_cast<std::size_t>(random.below(static_cast<long long>(all.size())))];
  const Stages& other = random.oneOf(all);
  const int kind = static_cast<int>(random.below(fuzz::KindCount));
  vtkPointSet* original = stages.data[kind];
  vtkSmartPointer<vtkPointSet> changed, source;
  changed.TakeReference(original->NewInstance());
  changed->DeepCopy(original);
  source.TakeReference(original->NewInstance());
  source->DeepCopy(other.data[kind]);
  stages.data[kind] = changed;
  std::string what;
  for (long long i = random.isTime(3) ? random.below(3) : 0; i >= 0; --i)
  {
    what += "  " + fuzz::mutate(changed, source, random) + "\n";
  }
  if (verbose)
  {
    std::printf(
      "seed %u, %s of %s:\n%s", seed, fuzz::kindName(kind), stages.name.c_str(), what.c_str());
    std::fflush(stdout);
  }
  const std::string faults = fuzz::faultsOf(stages, kind);
  if (!faults.empty())
  {
    std::printf("seed %u, %s of %s:\n%s%s", seed, fuzz::kindName(kind), stages.name.c_str(),
      verbose ? "" : what.c_str(), faults.c_str());
    std::fflush(stdout);
  }
  return faults.empty();
}

/// What a child tells its parent, even if it crashes.
struct Progress
{
  unsigned seed, faults;
};

/// Runs seeds from progress.seed on, to `end` at most, in a child.
void runBatch(const std::vector<Stages>& all, unsigned end, bool verbose, Progress& progress)
{
  const pid_t child = fork();
  if (child == 0)
  {
    for (; progress.seed != end; ++progress.seed)
    {
      limitTime();
      progress.faults += !isRight(all, progress.seed, verbose);
    }
    std::_Exit(0);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child)
  {
    throw std::runtime_error("no child can be started");
  }
  if (progress.seed != end)
  {
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    std::printf("seed %u: %s\n", progress.seed,
      signal == SIGPROF || signal == SIGALRM ? "takes too long"
        : signal                             ? strsignal(signal)
                                             : "ends the program");
    ++progress.faults;
    ++progress.seed;
  }
}
}

int main(int argc, char** argv)
{
  try
  {
    const Options options = optionsOf(argc, argv);
    vtkSMPTools::SetBackend("Sequential");                   // threads don't live on in a child
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // there are warnings of most changes
    const std::vector<Stages> all = allStages();
    auto* progress = static_cast<Progress*>(
      mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    if (progress == MAP_FAILED)
    {
      throw std::runtime_error("no memory can be shared");
    }
    *progress = { options.seed, 0 };
    constexpr unsigned batch = 1000;
    for (const unsigned end = options.seed + options.count; progress->seed != end;)
    {
      std::fflush(stdout);
      runBatch(
        all, progress->seed + std::min(batch, end - progress->seed), options.verbose, *progress);
    }
    std::printf(
      "%u changes from seed %u: %u faults\n", options.count, options.seed, progress->faults);
    return progress->faults == 0 ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
