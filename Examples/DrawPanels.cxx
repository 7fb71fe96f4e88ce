// SPDX-License-Identifier: BSD-3-Clause
//
// Draws files of SimplifyShape side by side, all seen from the same place.

#include "Canvas.h"
#include "DrawingProcess.h"
#include "DurableFiles.h"
#include "Errors.h"
#include "Messages.h"
#include "Options.h"
#include "Scenes.h"
#include "Signals.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <system_error>

namespace
{
struct Panel
{
  std::string file;
  std::string array; ///< empty: the file is a surface
  std::string caption;
};

struct PanelArguments
{
  std::string picture;
  std::vector<Panel> panels;
  std::array<double, 3> towardsViewer = { 0.35, 0.25, 1 };
  int columns = 0; ///< 0: all panels in a row
  int size = 300;
  bool help = false;
};

Panel parsePanel(const std::string& word)
{
  const std::size_t first = word.find(':');
  const std::size_t last = word.rfind(':');
  if (first == std::string::npos)
  {
    throw UsageError("'" + word + "' is not a panel; write FILE.vtp:CAPTION for a surface or " +
      "FILE.vtp:ARRAY:CAPTION for an axis");
  }
  return { word.substr(0, first), first == last ? "" : word.substr(first + 1, last - first - 1),
    word.substr(last + 1) };
}

std::array<double, 3> parseDirection(const std::string& text)
{
  std::array<double, 3> direction = { 0, 0, 0 };
  const std::vector<std::string> words = split(text, ",");
  bool isDirection = words.size() == 3;
  for (std::size_t k = 0; isDirection && k < 3; ++k)
  {
    const bool isNegative = words[k][0] == '-';
    isDirection = parseNumber(words[k].substr(isNegative ? 1 : 0), direction[k]);
    direction[k] *= isNegative ? -1 : 1;
  }
  if (!isDirection || direction == std::array<double, 3>{ 0, 0, 0 })
  {
    throw UsageError("'" + text + "' is not a direction; as in --view=1,-1,0.3");
  }
  return direction;
}

int parseSize(const std::string& option, const std::string& text)
{
  int number = 0;
  if (!parseCount(text, number) || number < 1)
  {
    throw UsageError(option + " takes a number from 1 on, not '" + text + "'");
  }
  return number;
}

std::vector<Option> optionsOf(PanelArguments& arguments)
{
  return {
    { "--view", "X,Y,Z",
      "direction from the object to the viewer (default: 0.35,0.25,1); y is up, or z\n"
      "if the direction is near y",
      [&](const std::string& text) { arguments.towardsViewer = parseDirection(text); } },
    { "--columns", "N", "panels in a row (default: all)",
      [&](const std::string& text) { arguments.columns = parseSize("--columns", text); } },
    { "--size", "N", "pixels of a panel's sides (default: 300)",
      [&](const std::string& text) { arguments.size = parseSize("--size", text); } },
    { "--help", "", "prints this", [&](const std::string&) { arguments.help = true; } },
  };
}

std::string usage()
{
  PanelArguments defaults;
  return R"(Draws files of SimplifyShape side by side, all seen from the same place.

  DrawPanels PICTURE.png PANEL ... [options]

A PANEL is FILE.vtp:CAPTION for a surface, or FILE.vtp:ARRAY:CAPTION for an axis coloured by an array
of its cells. PartId has a colour for each part. Other arrays go from dark blue to yellow in equal
ratios, from a thousandth of the largest value up. The first panel's object fills its panel.
Needs an X server (DISPLAY; xvfb-run will do).

)" + helpOf(optionsOf(defaults));
}

PanelArguments parseArguments(int argc, char* argv[])
{
  PanelArguments arguments;
  parse(argc, argv, "DrawPanels", optionsOf(arguments), [&](const std::string& word) {
    if (arguments.picture.empty())
    {
      arguments.picture = word;
    }
    else
    {
      arguments.panels.push_back(parsePanel(word));
    }
  });
  if (!arguments.help && arguments.panels.empty())
  {
    throw UsageError("no panel is given; DrawPanels --help tells how to use it");
  }
  return arguments;
}

vtkSmartPointer<vtkPolyData> read(const std::string& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetOutput()->GetNumberOfCells() == 0)
  {
    throw InputError(file + ": has no cells, or isn't there");
  }
  return reader->GetOutput();
}

void draw(const PanelArguments& arguments)
{
  const int size = arguments.size, count = static_cast<int>(arguments.panels.size());
  const int columns = arguments.columns > 0 ? arguments.columns : count;
  const int rows = (count + columns - 1) / columns;
  Canvas canvas(columns * size, rows * size);
  std::optional<View> view;
  for (int i = 0; i < count; ++i)
  {
    const Panel& panel = arguments.panels[i];
    const auto data = read(panel.file);
    view = view ? view : View(data, arguments.towardsViewer);
    const auto actor = panel.array.empty()
      ? surfaceActor(data)
      : arrayActor(data, panel.array, 0.7 * Canvas::Oversampling);
    const double left = i % columns * size, bottom = (rows - 1 - i / columns) * size;
    canvas.draw(actor, *view, { left, bottom, double(size), double(size) }, panel.caption);
  }
  try
  {
    replaceFile(arguments.picture, canvas.png(9));
  }
  catch (const std::system_error& error)
  {
    throw InputError(arguments.picture + ": can't be written: " + error.code().message());
  }
}

int fail(const std::exception& error, ExitCode code)
{
  std::cerr << "DrawPanels: " << error.what() << '\n';
  return code;
}
}

int main(int argc, char* argv[])
{
  try
  {
    signals::take("DrawPanels");
    const PanelArguments arguments = parseArguments(argc, argv);
    if (arguments.help)
    {
      std::cout << usage();
      return Done;
    }
    messages::capture(true);
    DrawingProcess process("the picture", [&](const std::string&) { draw(arguments); });
    process.draw(arguments.picture);
    return Done;
  }
  catch (const UsageError& error)
  {
    return fail(error, WrongUsage);
  }
  catch (const std::exception& error)
  {
    return fail(error, UnusableInput);
  }
}
