// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <iostream>
#include <vector>

namespace
{
bool Quiet = false;
std::vector<std::string> Errors;
std::vector<std::string> Warnings;

/// The message alone, on one line: "ERROR: In x.cxx, line 1\nvtkThing (0x1): message\n\n" becomes
/// "message". VTK's readers and writers offer nothing better; our filters do, see
/// vtkSimplifyShape::GetErrorMessage().
std::string plainText(std::string text)
{
  const std::size_t object = text.find("): ");
  if (text.find(", line ") != std::string::npos && object != std::string::npos)
  {
    text.erase(0, object + 3);
  }
  text.erase(text.find_last_not_of(" \n\r\t") + 1);
  for (char& c : text)
  {
    c = c == '\n' ? ' ' : c;
  }
  return text;
}

class MessageWindow : public vtkOutputWindow
{
public:
  static MessageWindow* New();
  vtkTypeMacro(MessageWindow, vtkOutputWindow);

  void DisplayErrorText(const char* text) override { Errors.push_back(plainText(text)); }
  void DisplayWarningText(const char* text) override { Warnings.push_back(plainText(text)); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(MessageWindow);

/// Is the error more than what VTK's pipeline reports of every filter that fails? The filter has told
/// the reason before.
bool isReason(const std::string& error)
{
  return error.find("returned failure for request") == std::string::npos;
}
}

namespace messages
{
void capture(bool quiet)
{
  Quiet = quiet;
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<MessageWindow> window;
  vtkOutputWindow::SetInstance(window);
}

void clear(const std::vector<std::string>& told)
{
  for (const std::string& warning : Warnings)
  {
    const bool isNew = std::find(told.begin(), told.end(), warning) == told.end();
    if (!Quiet && Errors.empty() && isNew)
    {
      std::cerr << "warning: " << warning << '\n';
    }
  }
  Errors.clear();
  Warnings.clear();
}

std::string error()
{
  for (const std::string& error : Errors)
  {
    if (isReason(error))
    {
      return error;
    }
  }
  if (!Errors.empty())
  {
    return Warnings.empty() ? "failed without a reason" : Warnings.front();
  }
  return "";
}
}
