// SPDX-License-Identifier: BSD-3-Clause
#ifndef DrawingProcess_h
#define DrawingProcess_h

#include <functional>
#include <string>
#include <sys/types.h>

/// A process of its own that draws with VTK. If the X server goes away, Xlib ends the process that uses
/// it, and VTK aborts it; that must not be the one with the results. The process connects to the server
/// when it begins and stays connected until it ends, so a server that resets after its last client
/// does not reset between two pictures.
class DrawingProcess
{
public:
  /// Draws what the text asks for. Runs in the other process.
  using Draw = std::function<void(const std::string& order)>;

  /// Starts the process. Call it before other threads use VTK: the process is a copy of this one.
  /// @param asker  what needs a display, for the message
  /// @throw UsageError  there is no X server to draw with
  DrawingProcess(const std::string& asker, const Draw& draw);

  /// Ends the process.
  ~DrawingProcess();

  DrawingProcess(const DrawingProcess&) = delete;
  DrawingProcess& operator=(const DrawingProcess&) = delete;

  /// Lets it draw, once, and waits for it.
  /// @throw UsageError, InputError  what `draw` threw
  /// @throw InputError              the process has died, or does not answer any more
  void draw(const std::string& order);

private:
  void start(const Draw& draw);
  void end();
  bool isReady() const;

  pid_t Child = -1;
  int Socket = -1;
};

#endif
