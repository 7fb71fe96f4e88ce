// SPDX-License-Identifier: BSD-3-Clause
#include "ChildProcess.h"

#include "Errors.h"
#include "Signals.h"

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <new>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
#ifdef __SANITIZE_ADDRESS__
constexpr bool limitsMemory = false; // the sanitizer takes terabytes of address space
#else
constexpr bool limitsMemory = true;
#endif

void limit(int resource, rlim_t value)
{
  rlimit current = {};
  getrlimit(resource, &current);
  current.rlim_cur = current.rlim_max < value ? current.rlim_max : value;
  setrlimit(static_cast<__rlimit_resource>(resource), &current);
}

/// Bytes of address space that the process has.
std::size_t addressSpace()
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void apply(const Limits& limits)
{
  const double whole = std::floor(limits.seconds);
  itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (limits.seconds - whole));
  setitimer(ITIMER_PROF, &timer, nullptr); // SIGPROF ends the process
  if (limitsMemory)
  {
    limit(RLIMIT_AS, addressSpace() + limits.bytes);
  }
}

void printNowhere()
{
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

std::string deathOf(int status)
{
  return WIFSIGNALED(status)
    ? std::string("was ended by the signal ") + strsignal(WTERMSIG(status)) +
      (WTERMSIG(status) == SIGKILL ? ", often for lack of memory" : "")
    : "had not enough memory";
}

void writeAll(int pipe, const std::string& text)
{
  std::size_t written = 0;
  while (written < text.size())
  {
    const ssize_t count = write(pipe, text.data() + written, text.size() - written);
    if (count < 0 && errno != EINTR)
    {
      _exit(1);
    }
    written += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
}

std::string readAll(int pipe)
{
  std::string text;
  char buffer[65536];
  ssize_t count = 0;
  while ((count = read(pipe, buffer, sizeof buffer)) != 0)
  {
    if (count < 0 && errno != EINTR)
    {
      break;
    }
    text.append(buffer, count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return text;
}

/// What the child does: the first byte tells how it ended. No destructor and no exit handler of the
/// program runs here.
[[noreturn]] void work(
  const std::function<std::string()>& make, const std::optional<Limits>& limits, int pipe) noexcept
{
  try
  {
    signals::beginChild();
    if (limits)
    {
      apply(*limits);
    }
    printNowhere();
    const std::string text = make();
    writeAll(pipe, "r");
    writeAll(pipe, text);
  }
  catch (const std::bad_alloc&)
  {
    _exit(1); // beyond the limit
  }
  catch (const std::exception& error)
  {
    writeAll(pipe, std::string("t") + error.what());
  }
  _exit(0);
}
}

ChildResult inChildProcess(
  const std::function<std::string()>& make, const std::optional<Limits>& limits)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw InputError(std::string("can't make a pipe: ") + std::strerror(errno));
  }
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    work(make, limits, ends[1]);
  }
  close(ends[1]);
  if (child < 0)
  {
    close(ends[0]);
    throw InputError(std::string("can't make a process: ") + std::strerror(errno));
  }
  std::string text = readAll(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || text.empty())
  {
    return { Ending::Died, deathOf(status) };
  }
  const Ending ending = text[0] == 'r' ? Ending::Returned : Ending::Threw;
  return { ending, text.erase(0, 1) };
}
