// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "Messages.h"
#include "Verdict.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkSmartPointer.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sys/resource.h>
#include <unistd.h>

namespace
{
/// One line of the terminal, drawn again whenever a whole per cent is done.
class Bar
{
public:
  Bar(const std::string& stage, bool visible)
    : Stage(stage)
    , Visible(visible)
  {
    this->draw(0);
  }

  void draw(int percent)
  {
    if (this->Visible && percent > this->Percent)
    {
      this->Percent = percent;
      const int full = percent * Width / 100;
      std::fprintf(stderr, "\r%-12s [%s%s] %3d %%", this->Stage.c_str(),
        std::string(full, '#').c_str(), std::string(Width - full, '.').c_str(), percent);
      std::fflush(stderr);
    }
  }

  /// Draws the full bar, with the time, and goes to the next line.
  void finish(double seconds)
  {
    this->draw(100);
    if (this->Visible)
    {
      std::fprintf(stderr, "%9.1f s\n", seconds);
    }
  }

  /// Wipes the line, so that an error message can be printed there.
  void wipe()
  {
    if (this->Visible)
    {
      std::fprintf(stderr, "\r\033[K");
    }
  }

private:
  static constexpr int Width = 40;
  std::string Stage;
  bool Visible;
  int Percent = -1;
};
}

/// One stage, from its StartEvent to its EndEvent.
class Progress::Stage
{
public:
  Stage(const std::string& name, vtkAlgorithm* filter, bool visible)
    : Name(name)
    , Filter(filter)
    , Visible(visible)
    , Observers{ filter->AddObserver(vtkCommand::StartEvent, this, &Stage::begin),
      filter->AddObserver(vtkCommand::ProgressEvent, this, &Stage::draw),
      filter->AddObserver(vtkCommand::EndEvent, this, &Stage::end) }
  {
  }
  ~Stage()
  {
    for (const unsigned long observer : this->Observers)
    {
      this->Filter->RemoveObserver(observer);
    }
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  double seconds() const { return this->Seconds; }
  bool isOf(vtkAlgorithm* filter) const { return filter == this->Filter; }

private:
  using Clock = std::chrono::steady_clock;

  void begin()
  {
    this->Line.emplace(this->Name, this->Visible);
    this->Begin = Clock::now();
  }

  void draw()
  {
    if (this->Line)
    {
      this->Line->draw(static_cast<int>(100 * this->Filter->GetProgress()));
    }
  }

  /// The stage's warnings are printed below its bar, but for those that the summary tells. Errors are
  /// kept for who updates the filter.
  void end()
  {
    if (!this->Line)
    {
      return;
    }
    this->Seconds = std::chrono::duration<double>(Clock::now() - this->Begin).count();
    if (this->Filter->GetErrorCode() != vtkErrorCode::NoError || !messages::error().empty())
    {
      this->Line->wipe();
    }
    else
    {
      this->Line->finish(this->Seconds);
      messages::clear(eventsOf(this->Filter->GetOutputDataObject(0)));
    }
    this->Line.reset();
  }

  std::string Name;
  vtkSmartPointer<vtkAlgorithm> Filter;
  bool Visible;
  std::array<unsigned long, 3> Observers;
  std::optional<Bar> Line; ///< while the stage runs
  Clock::time_point Begin;
  double Seconds = 0;
};

Progress::Progress(bool quiet)
  : Visible(!quiet && isatty(fileno(stderr)))
{
}

Progress::~Progress() = default;

void Progress::watch(const std::string& name, vtkAlgorithm* stage)
{
  this->Stages.push_back(std::make_unique<Stage>(name, stage, this->Visible));
}

double Progress::seconds(vtkAlgorithm* stage) const
{
  for (const auto& watched : this->Stages)
  {
    if (watched->isOf(stage))
    {
      return watched->seconds();
    }
  }
  return 0;
}

double peakMemoryMiB()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return std::round(usage.ru_maxrss / 1024.0); // Linux counts in KiB
}
