// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingProcess.h"

#include "Canvas.h"
#include "Errors.h"
#include "Signals.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace
{
using namespace std::chrono_literals;

/// A server that is just resetting, after the client before us, is back within a tenth of a second.
constexpr int Attempts = 8;
constexpr auto Pause = 150ms;

/// A server that takes longer for these hangs. Large axes take seconds without a graphics card.
constexpr auto TimeToConnect = 20s;
constexpr auto TimeToDraw = 600s;

constexpr std::size_t LongestMessage = 64 * 1024;

bool send(int socket, const std::string& message)
{
  return ::send(socket, message.data(), message.size(), MSG_NOSIGNAL) >= 0;
}

/// Nothing if the other side is gone or the time is over.
std::optional<std::string> receive(int socket, std::chrono::milliseconds time)
{
  pollfd waiting = { socket, POLLIN, 0 };
  int ready = 0;
  do
  {
    ready = poll(&waiting, 1, static_cast<int>(time.count()));
  }
  while (ready < 0 && errno == EINTR);
  std::vector<char> buffer(LongestMessage);
  const ssize_t size = ready > 0 ? recv(socket, buffer.data(), buffer.size(), 0) : 0;
  return size > 0 ? std::optional<std::string>(std::string(buffer.data(), size)) : std::nullopt;
}

/// One digit, the exit code, before the message.
std::string answerOf(ExitCode code, const std::string& message)
{
  return std::to_string(code) + message;
}

/// What the other process does, from its beginning to its end.
[[noreturn]] void work(int socket, const DrawingProcess::Draw& draw)
{
  signals::beginChild();
  const bool isSilent = std::freopen("/dev/null", "w", stderr) != nullptr; // Xlib's last words
  keepDisplay();
  std::string answer = answerOf(isSilent ? Done : UnusableInput, "");
  const auto order = send(socket, answer) ? receive(socket, -1ms) : std::nullopt;
  try
  {
    if (order)
    {
      draw(*order);
    }
  }
  catch (const UsageError& error)
  {
    answer = answerOf(WrongUsage, error.what());
  }
  catch (const std::exception& error)
  {
    answer = answerOf(UnusableInput, error.what());
  }
  send(socket, answer);
  std::_Exit(EXIT_SUCCESS); // the window stays open until here
}
}

DrawingProcess::DrawingProcess(const std::string& asker, const Draw& draw)
{
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
  {
    throw UsageError(asker +
      " needs an X server, but DISPLAY is not set; use Examples/run, which "
      "starts one, or xvfb-run");
  }
  const auto deadline = std::chrono::steady_clock::now() + TimeToConnect;
  for (int attempt = 0; attempt < Attempts && !this->isReady(); ++attempt)
  {
    if (std::chrono::steady_clock::now() > deadline)
    {
      break;
    }
    std::this_thread::sleep_for(attempt > 0 ? Pause : 0ms);
    this->start(draw);
  }
  if (!this->isReady())
  {
    throw UsageError(asker + " needs an X server with OpenGL, but none answers at DISPLAY=" +
      display + "; use Examples/run, which starts one, or xvfb-run");
  }
}

DrawingProcess::~DrawingProcess()
{
  this->end();
}

bool DrawingProcess::isReady() const
{
  return this->Child > 0;
}

void DrawingProcess::start(const Draw& draw)
{
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets) != 0)
  {
    return;
  }
  this->Child = fork();
  if (this->Child == 0)
  {
    close(sockets[0]);
    work(sockets[1], draw);
  }
  close(sockets[1]);
  this->Socket = sockets[0];
  if (this->Child < 0 || !receive(this->Socket, TimeToConnect))
  {
    this->end();
  }
}

void DrawingProcess::end()
{
  if (this->Child > 0)
  {
    kill(this->Child, SIGKILL);
    waitpid(this->Child, nullptr, 0);
  }
  this->Child = -1;
  if (this->Socket >= 0)
  {
    close(std::exchange(this->Socket, -1));
  }
}

void DrawingProcess::draw(const std::string& order)
{
  send(this->Socket, order);
  const auto answer = receive(this->Socket, TimeToDraw);
  this->end();
  if (!answer)
  {
    throw InputError("the X server went away or does not answer");
  }
  const std::string message = answer->substr(1);
  switch (answer->front() - '0')
  {
    case Done:
      return;
    case WrongUsage:
      throw UsageError(message);
    default:
      throw InputError(message);
  }
}
