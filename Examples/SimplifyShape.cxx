// SPDX-License-Identifier: BSD-3-Clause
//
// Simplifies the shape of a solid, given by points of its boundary, by pruning its medial axis.
// What it does with VTK is in Pipeline.cxx; this file connects it with the command line.

#include "Arguments.h"
#include "Errors.h"
#include "Messages.h"
#include "OutputFolder.h"
#include "Pictures.h"
#include "Pipeline.h"
#include "Progress.h"
#include "ReadPoints.h"
#include "Report.h"
#include "Tables.h"
#include "Triangles.h"

#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSTLWriter.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <chrono>
#include <exception>
#include <iostream>

namespace
{
/// As text within the XML: with the expat of an updated Debian 12 ParaView 5.11 can't read the writers'
/// default, raw data after the XML.
template <typename Writer>
void write(vtkDataObject* data, const std::string& name, OutputFolder& folder)
{
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetDataModeToBinary();
  folder.write(writer.Get(), name);
}

void writeData(const Pipeline& pipeline, OutputFolder& folder)
{
  write<vtkXMLUnstructuredGridWriter>(pipeline.balls->GetOutput(), "balls.vtu", folder);
  write<vtkXMLPolyDataWriter>(pipeline.axis->GetOutput(), "axis.vtp", folder);
  write<vtkXMLPolyDataWriter>(pipeline.parts->GetOutput(), "parts.vtp", folder);
  write<vtkXMLPolyDataWriter>(pipeline.prune->GetOutput(), "pruned.vtp", folder);
  write<vtkXMLPolyDataWriter>(pipeline.crust->GetOutput(), "surface.vtp", folder);
  vtkNew<vtkSTLWriter> triangles;
  triangles->SetInputData(inTriangles(pipeline.crust->GetOutput()));
  triangles->SetFileTypeToBinary();
  folder.write(triangles.Get(), "surface.stl");
  folder.writeText(
    csv(vtkTable::SafeDownCast(pipeline.parts->GetOutputDataObject(1))), "parts.csv");
  folder.writeText(
    csv(vtkTable::SafeDownCast(pipeline.prune->GetOutputDataObject(1))), "history.csv");
}

Stages stagesOf(const Pipeline& pipeline, vtkPolyData* samples)
{
  const auto parts = [](vtkDataObject* axis) {
    const double count = fieldValue(axis, "NumberOfParts");
    return grouped(count) + (count == 1 ? " part" : " parts");
  };
  return { {
    { "samples", grouped(double(samples->GetNumberOfPoints())) + " samples", samples },
    { "axis", "medial axis", pipeline.axis->GetOutput() },
    { "parts", parts(pipeline.parts->GetOutput()), pipeline.parts->GetOutput() },
    { "pruned", "pruned to " + parts(pipeline.prune->GetOutput()), pipeline.prune->GetOutput() },
    { "surface", "simplified surface", pipeline.crust->GetOutput() },
  } };
}

ExitCode simplify(const Arguments& arguments)
{
  const auto begin = std::chrono::steady_clock::now();
  if (arguments.picture)
  {
    checkDisplay();
  }
  if (arguments.threads > 0)
  {
    vtkSMPTools::Initialize(arguments.threads);
  }
  auto samples = readPoints(arguments.input);
  OutputFolder folder(arguments.output);
  Pipeline pipeline(samples, arguments);
  Progress progress(arguments.input, arguments.quiet);
  pipeline.run(progress, arguments);
  const double total =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  writeData(pipeline, folder);
  if (arguments.picture)
  {
    drawPictures(stagesOf(pipeline, samples), folder);
  }
  folder.writeText(report(pipeline, total), "report.json");
  folder.publish();
  if (!arguments.quiet)
  {
    std::cout << summary(pipeline, arguments, total);
  }
  if (arguments.strict && !isCertified(pipeline))
  {
    std::cerr << "SimplifyShape: the topology of the axis is not certified; see betti in "
              << arguments.output << "/report.json\n";
    return NotCertified;
  }
  return Done;
}

int fail(const std::exception& error, ExitCode code)
{
  std::cerr << "SimplifyShape: " << error.what() << '\n';
  return code;
}
}

int main(int argc, char* argv[])
{
  try
  {
    const Arguments arguments = parseArguments(argc, argv);
    if (arguments.help)
    {
      std::cout << usage();
      return Done;
    }
    messages::capture(arguments.quiet);
    return simplify(arguments);
  }
  catch (const UsageError& error)
  {
    return fail(error, WrongUsage);
  }
  catch (const std::exception& error) // InputError, out of memory, ...
  {
    return fail(error, UnusableInput);
  }
}
