// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <iostream>

namespace
{
bool Quiet = false;
std::string FirstError;

/// "ERROR: In x.cxx, line 1\nvtkThing (0x1): message\n\n" -> "message", on one line.
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

  void DisplayErrorText(const char* text) override
  {
    FirstError = FirstError.empty() ? plainText(text) : FirstError;
  }
  void DisplayWarningText(const char* text) override { this->print("warning: ", text); }
  void DisplayGenericWarningText(const char* text) override { this->print("warning: ", text); }
  void DisplayText(const char* text) override { this->print("", text); }
  void DisplayDebugText(const char*) override {}

private:
  void print(const char* prefix, const char* text) const
  {
    if (!Quiet)
    {
      std::cerr << prefix << plainText(text) << '\n';
    }
  }
};
vtkStandardNewMacro(MessageWindow);
}

namespace messages
{
void capture(bool quiet)
{
  Quiet = quiet;
  vtkNew<MessageWindow> window;
  vtkOutputWindow::SetInstance(window);
}

void clear()
{
  FirstError.clear();
}

std::string firstError()
{
  return FirstError;
}
}
