// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks.h"

#include "Errors.h"
#include "Options.h"

#include <cstdlib>
#include <string>
#include <unistd.h>

namespace
{
struct Launcher
{
  const char* number;
  const char* count;
  const char* needed; ///< a variable that must be there, too
};

constexpr Launcher Launchers[] = {
  { "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK" },
  { "PMI_RANK", "PMI_SIZE", "PMI_RANK" },
  { "SLURM_PROCID", "SLURM_NTASKS", "SLURM_STEP_ID" },
};

/// From the launcher, else from the batch system, else the process that started them.
std::string runOfLauncher()
{
  for (const char* name : { "PMIX_NAMESPACE", "SLURM_JOB_ID", "PBS_JOBID", "LSB_JOBID" })
  {
    const char* step = std::getenv("SLURM_STEP_ID");
    if (const char* value = std::getenv(name))
    {
      return std::string(value) + (step ? std::string("-") + step : "");
    }
  }
  return std::to_string(getppid());
}
}

Rank rankOfLauncher()
{
  for (const Launcher& launcher : Launchers)
  {
    const char *number = std::getenv(launcher.number), *count = std::getenv(launcher.count);
    if (number && count && std::getenv(launcher.needed))
    {
      Rank rank;
      if (!parseCount(number, rank.number) || !parseCount(count, rank.count) ||
        rank.number >= rank.count)
      {
        throw UsageError(std::string(launcher.number) + "=" + number + " and " + launcher.count +
          "=" + count + " name no process of several; unset them to work with one process");
      }
      rank.run = runOfLauncher();
      return rank;
    }
  }
  return { 0, 1, std::to_string(getpid()) };
}
