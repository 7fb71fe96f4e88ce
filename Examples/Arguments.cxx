// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "Errors.h"
#include "ImageOptions.h"
#include "Lines.h"
#include "MeasuringOptions.h"
#include "Messages.h"
#include "Morphometry.h"
#include "Options.h"

#include <vtkMedialPrune.h>
#include <vtkNew.h>
#include <vtkSimplifyShape.h>

#include <cmath>

namespace
{
std::vector<int> parsePartIds(const std::string& list)
{
  std::vector<int> ids;
  for (const std::string& word : split(list, ", "))
  {
    int id = 0;
    if (!parseCount(word, id))
    {
      throw UsageError("'" + word + "' is not a part; --remove-parts takes values of PartId from " +
        "parts.vtp, as in --remove-parts 12,40");
    }
    ids.push_back(id);
  }
  if (ids.empty())
  {
    throw UsageError("--remove-parts names no part; as in --remove-parts 12,40");
  }
  return ids;
}

bool parseTopology(const std::string& word)
{
  if (word != "collapse" && word != "none")
  {
    throw UsageError("--topology is 'collapse' or 'none', not '" + word + "'");
  }
  return word == "collapse";
}

double parseLength(const char* option, const std::string& word)
{
  double length = 0;
  if (!parseReal(word, length) || !(length >= 0) || !std::isfinite(length))
  {
    throw UsageError(std::string(option) + " takes a length from 0 on, not '" + word + "'");
  }
  return length;
}

double parseFineness(const std::string& word)
{
  double fineness = 0;
  if (!parseReal(word, fineness) || !(fineness > 0 && fineness <= 1))
  {
    throw UsageError("--fineness takes a number above 0, at most 1, not '" + word + "'");
  }
  return fineness;
}

int parseThreads(const std::string& word)
{
  int threads = 0;
  if (!parseCount(word, threads) || threads < 1)
  {
    throw UsageError("--threads takes a number from 1 on, not '" + word + "'");
  }
  return threads;
}

/// Describes the words of a schedule, from the filter's table of measures.
std::string scheduleHelp()
{
  std::string text = "the iterations of pruning, in order; or the name of a preset:\n";
  for (int preset = 0; vtkMedialPrune::GetPresetName(preset); ++preset)
  {
    const std::string name = vtkMedialPrune::GetPresetName(preset);
    text += "  " + name + (preset == 0 ? " (default)" : "") + ", \"" +
      vtkMedialPrune::GetPresetWords(preset) + "\":\n    " +
      vtkMedialPrune::GetPresetDescription(preset) + '\n';
  }
  text += "Each word removes the parts with at most the value N, P or X as\n";
  for (int measure = 0; vtkMedialPrune::GetMeasureName(measure); ++measure)
  {
    std::string word = "  " + vtkMedialPrune::GetMeasureWord(measure);
    word.resize(7, ' ');
    text += word + vtkMedialPrune::GetMeasureDescription(measure) + '\n';
  }
  return text +
    "Lengths and areas are in the unit of the samples; a length with s\n"
    "is in mean sample spacings, with % in per cent of the diagonal of\n"
    "the samples' bounding box.\n"
    "x and a number at the end limit the passes: t5x1.\n"
    "An empty schedule prunes nothing.";
}

/// Lets the filter read the words before there is anything to work on.
/// @throw UsageError  a word is wrong
void checkSchedule(const std::string& words)
{
  messages::capture(true);
  vtkNew<vtkSimplifyShape> filter;
  filter->SetSchedule(words.c_str());
  const std::string message = filter->GetErrorMessage();
  messages::clear();
  if (!message.empty())
  {
    throw UsageError("--schedule: " + message + "; --help explains them");
  }
}

auto turnsOn(bool& property)
{
  return [&property](const std::string&) { property = true; };
}

/// How points and polygons are used.
std::vector<Option> inputOptions(Arguments& arguments)
{
  return {
    { "--drop-invalid", "",
      "leaves out points with a coordinate that is NaN or infinite, and the polygons at them, and\n"
      "counts both",
      turnsOn(arguments.dropInvalid) },
    { "--merge-tolerance", "L",
      "takes samples so near each other for one where they stand apart from all others, in the\n"
      "unit of the samples (default: what the rounding of the file explains)",
      [&](const std::string& value) {
        arguments.mergeTolerance = parseLength("--merge-tolerance", value);
      } },
    { "--points", "", "takes the vertices of a mesh as samples, not its triangles",
      turnsOn(arguments.points) },
    { "--clean", "", "takes outliers and noise from the points of a scan; polygons are left out",
      turnsOn(arguments.clean) },
    { "--fineness", "F",
      "samples triangles at most F times the thickness of solid and gaps apart (default: 0.25)",
      [&](const std::string& value) { arguments.fineness = parseFineness(value); } },
    { "--spacing", "L",
      "samples triangles nowhere farther apart, in the unit of the mesh (default: so that there "
      "are\n"
      "20,000 to 50,000 samples)",
      [&](const std::string& value) { arguments.spacing = parseLength("--spacing", value); } },
    { "--wrap", "",
      "samples the closed surface around the polygons of a mesh where they bound no solid, "
      "because\n"
      "of holes or intersections",
      turnsOn(arguments.wrap) },
    { "--wrap-width", "L",
      "the same; it goes across gaps and holes that are narrower, in the unit of the mesh\n"
      "(default: a twenty-fifth of the diagonal)",
      [&](const std::string& value) {
        arguments.wrap = true;
        arguments.wrapWidth = parseLength("--wrap-width", value);
      } },
  };
}

/// What is done with the axis.
std::vector<Option> pruningOptions(Arguments& arguments)
{
  return {
    { "--output", "DIR", "where the results go (default: out)",
      [&](const std::string& value) {
        arguments.output = value;
        arguments.writesResults = true;
      } },
    { "--ma", "", "also writes axis.ma and pruned.ma, for Blender, Q-MAT, MATTopo and others",
      turnsOn(arguments.medialMeshes) },
    { "--export-parts", "",
      "also writes the surface of each part to a file of its own; open where parts touch each "
      "other",
      turnsOn(arguments.exportParts) },
    { "--trim", "X",
      "leaves out rims of the axis that small bumps of the surface make, up to an erosion "
      "thickness of\n"
      "X spacings of the samples (default: 0, none; 0.2 takes most of them)",
      [&](const std::string& value) { arguments.trim = parseLength("--trim", value); } },
    { "--schedule", "\"W W ...\"", scheduleHelp(),
      [&](const std::string& value) { arguments.schedule = value; } },
    { "--automatic", "", "chooses the iterations from the data instead",
      turnsOn(arguments.automatic) },
    { "--split-at-necks", "", "also cuts parts at necks, before any pruning; best on clean data",
      turnsOn(arguments.splitAtNecks) },
    { "--topology", "WORD",
      "collapse  removes a part only where tunnels, voids, pieces stay (default)\n"
      "none      removes it anyway",
      [&](const std::string& value) { arguments.keepTopology = parseTopology(value); } },
    { "--remove-parts", "ID,ID",
      "then removes these parts too, by PartId in parts.vtp and parts.csv",
      [&](const std::string& value) { arguments.partsToRemove = parsePartIds(value); } },
  };
}

/// How the program runs.
std::vector<Option> runOptions(Arguments& arguments)
{
  return {
    { "--threads", "N", "uses N threads (default: all; the result is the same)",
      [&](const std::string& value) { arguments.threads = parseThreads(value); } },
    { "--picture", "", "also draws the stages; needs an X server (DISPLAY), see Examples/run",
      turnsOn(arguments.picture) },
    { "--report", "",
      "also measures thickness, and writes a page for a browser; it has pictures where an X "
      "server\n"
      "is (DISPLAY)",
      turnsOn(arguments.page) },
    { "--strict", "",
      "fails (exit 3) unless the result is certified: power shape, axis, pruned axis\n"
      "and surface have the same topology, the surface is closed, no warning says\n"
      "that the samples may not determine the solid",
      turnsOn(arguments.strict) },
    { "--quiet", "", "prints errors only", turnsOn(arguments.quiet) },
    { "--help", "", "prints this", turnsOn(arguments.help) },
  };
}

/// All options: the command line is read by this table, and --help is made from it.
std::vector<Option> optionsOf(Arguments& arguments)
{
  std::vector<Option> result = pruningOptions(arguments);
  for (const auto& more : { inputOptions(arguments), imageOptions(arguments),
         measuringOptions(arguments), runOptions(arguments) })
  {
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

void completeInputs(Arguments& arguments)
{
  if (arguments.inputs.empty())
  {
    throw UsageError("no input is given; SimplifyShape --help tells how to use it");
  }
  if (arguments.cohort.empty() && arguments.inputs.size() > 1)
  {
    throw UsageError("one input at a time: both '" + arguments.inputs[0] + "' and '" +
      arguments.inputs[1] +
      "' are given; a schedule of several words needs quotes, several objects "
      "--cohort");
  }
  arguments.input = arguments.inputs.front();
}

/// Checks what depends on several words of the command line.
void complete(Arguments& arguments)
{
  if (arguments.help)
  {
    return;
  }
  completeInputs(arguments);
  if (arguments.output.empty())
  {
    throw UsageError("--output needs a folder");
  }
  if (arguments.automatic && arguments.schedule != Arguments().schedule)
  {
    throw UsageError("--automatic chooses the schedule; leave out --schedule, or --automatic");
  }
  if (arguments.iso && arguments.label)
  {
    throw UsageError("--iso or --label tells the solid of an image, not both");
  }
  for (const std::string& input : arguments.inputs)
  {
    checkImageOptions(arguments, input);
  }
  checkMeasuring(arguments);
  checkSchedule(arguments.schedule);
}
}

Arguments parseArguments(int argc, char* argv[])
{
  Arguments arguments;
  parse(argc, argv, "SimplifyShape", noted(optionsOf(arguments), arguments.settings),
    [&](const std::string& word) { arguments.inputs.push_back(word); });
  complete(arguments);
  return arguments;
}

std::string usage()
{
  Arguments defaults;
  return R"(Simplifies the shape of a solid by pruning its medial axis.

  SimplifyShape INPUT [options]
  SimplifyShape --cohort TABLE.csv INPUT... [options]

INPUT is a .ply .stl .obj .vtp .vtu .off .xyz or .csv file. Polygons that bound a solid are sampled; of
other files the points are taken as samples of the solid's closed boundary, and their normals tell
what is inside. Or it is an image, .vti .mha .mhd .nrrd .nii .nii.gz .dcm or a folder of DICOM files,
which the solid in it is cut out of.

)" + helpOf(optionsOf(defaults)) +
    R"(
Results, all or none:
  balls.vtu samples.vtp  polar balls and the dual of their power diagram; the samples
  axis.vtp  parts.vtp    medial axis; the same with its parts
  pruned.vtp             what pruning left of it
  surface.vtp  .stl      surface of the simplified solid; .stl in triangles
  part-N.stl exported.csv  with --export-parts: the triangles with PartId N; a list of them
  axis.ma pruned.ma      with --ma: axis and pruned axis as medial meshes
  parts.csv history.csv  the parts; what each iteration removed
  report.json            counts, Betti numbers, verdict, warnings, volumes, times
  morphometry.csv        with --morphometry
  report.html thickness.vtp  with --report: a page; the surface with its Thickness
  samples axis parts pruned surface overview .png with --picture

)" + quantityHelp() +
    R"(
Exit: 0 done, 1 wrong usage, 2 input or output can't be used, 3 see --strict,
4 the table of a cohort is written, but some of its objects failed,
130 ended by Ctrl-C, 143 by SIGTERM, 129 by SIGHUP.
)";
}
