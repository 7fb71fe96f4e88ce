// SPDX-License-Identifier: BSD-3-Clause
#include "Signals.h"

#include <csignal>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace
{
/// They live until the process ends, since the thread that uses them does.
std::mutex& gate()
{
  static auto* mutex = new std::mutex;
  return *mutex;
}

std::function<void()>& cleanUpAction()
{
  static auto* action = new std::function<void()>;
  return *action;
}

sigset_t MaskBefore;

bool isIgnored(int signal)
{
  struct sigaction action = {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

void endBySignal(const std::string& program, sigset_t awaited)
{
  int signal = 0;
  while (sigwait(&awaited, &signal) != 0)
  {
  }
  gate().lock(); // for good: whoever needs a shield now waits for the end
  if (cleanUpAction())
  {
    cleanUpAction()();
  }
  pollfd terminal = { STDERR_FILENO, POLLOUT, 0 };
  if (poll(&terminal, 1, 0) == 1 && terminal.revents == POLLOUT) // else nobody reads it
  {
    dprintf(STDERR_FILENO, "\n%s: ended by %s\n", program.c_str(), strsignal(signal));
  }
  _exit(128 + signal);
}
}

namespace signals
{
void take(const std::string& program)
{
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  sigset_t awaited;
  sigemptyset(&awaited);
  for (int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    if (!isIgnored(signal))
    {
      sigaddset(&awaited, signal);
    }
  }
  pthread_sigmask(SIG_BLOCK, &awaited, &MaskBefore); // threads that begin later inherit it
  std::thread(endBySignal, program, awaited).detach();
}

void beginChild()
{
  pthread_sigmask(SIG_SETMASK, &MaskBefore, nullptr);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit noCore = { 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
}

Shield::Shield()
{
  gate().lock();
}

Shield::~Shield()
{
  gate().unlock();
}

void setCleanUp(std::function<void()> cleanUp)
{
  cleanUpAction() = std::move(cleanUp);
}
}
