// SPDX-License-Identifier: BSD-3-Clause
#include "Stopwatch.h"

#include <chrono>
#include <fstream>
#include <string>

#include <sys/resource.h>

namespace
{
/// Of this process alone; what getrusage tells is that of the parent, too, if that has had more.
std::size_t peakMemory()
{
  std::ifstream status("/proc/self/status");
  std::size_t result = 0;
  for (std::string word; status >> word;)
  {
    if (word == "VmHWM:")
    {
      status >> result;
    }
  }
  return result;
}
}

Usage usage()
{
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
  return { static_cast<double>(used.ru_utime.tv_sec) +
      1e-6 * static_cast<double>(used.ru_utime.tv_usec),
    now.count(), peakMemory() };
}

void forgetPeak()
{
  std::ofstream("/proc/self/clear_refs") << 5;
}
