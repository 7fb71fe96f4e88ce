// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "Errors.h"
#include "Messages.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>

#include <chrono>
#include <cstdio>
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

  void observe(vtkObject* caller, unsigned long, void*)
  {
    this->draw(static_cast<int>(100 * static_cast<vtkAlgorithm*>(caller)->GetProgress()));
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

  /// Wipes the line, for an error to stand there.
  void wipe()
  {
    if (this->Visible)
    {
      std::fprintf(stderr, "\r\033[K");
    }
  }

private:
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

  static constexpr int Width = 40;
  std::string Stage;
  bool Visible;
  int Percent = -1;
};
}

Progress::Progress(const std::string& subject, bool quiet)
  : Subject(subject)
  , Visible(!quiet && isatty(fileno(stderr)))
{
}

double Progress::run(const std::string& stage, vtkAlgorithm* filter)
{
  using Clock = std::chrono::steady_clock;
  Bar bar(stage, this->Visible);
  const unsigned long observer =
    filter->AddObserver(vtkCommand::ProgressEvent, &bar, &Bar::observe);
  const auto begin = Clock::now();
  filter->Update();
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  filter->RemoveObserver(observer);
  if (filter->GetErrorCode() != vtkErrorCode::NoError || !messages::error().empty())
  {
    bar.wipe();
    const std::string message = messages::error();
    throw InputError(
      this->Subject + ": " + (message.empty() ? stage + " failed without a reason" : message));
  }
  bar.finish(seconds);
  messages::clear();
  return seconds;
}
