// SPDX-License-Identifier: BSD-3-Clause
#ifndef Signals_h
#define Signals_h

#include <functional>
#include <string>

/// What signals do to a program. SIGINT (Ctrl-C), SIGTERM and SIGHUP clean up and end it at once,
/// whatever it computes, with exit code 128 + signal: 130, 143, 129. One that the program's starter
/// ignores, as nohup does, stays ignored. A write into a closed pipe, or beyond the size that
/// `ulimit -f` allows, is an error of that write and doesn't end the program.
namespace signals
{
/// Begins to take the signals, in a thread of its own: nothing has to wait for the stage that runs.
/// Call it before other threads begin.
/// @param program  its name, for the message
void take(const std::string& program);

/// The first thing that a child process, made by fork(), does. It takes signals as they were before take(),
/// ends when this process ends, and leaves no core file.
void beginChild();

/// While one lives, no signal ends the program; those that come are taken afterwards.
class Shield
{
public:
  Shield();
  ~Shield();
  Shield(const Shield&) = delete;
  Shield& operator=(const Shield&) = delete;
};

/// Sets what is called before a signal ends the program, in another thread and never while a shield
/// lives. Call it behind a shield.
void setCleanUp(std::function<void()> cleanUp);
}

#endif
