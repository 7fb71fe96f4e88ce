// SPDX-License-Identifier: BSD-3-Clause
//
// Simplifies the shape of a solid, given by a mesh or points of its boundary, by pruning its medial axis.
// The filter vtkSimplifyShape does the work; the program reads its input and writes its outputs.

#include "Arguments.h"
#include "Cohort.h"
#include "DrawingProcess.h"
#include "Errors.h"
#include "ImageNames.h"
#include "Lines.h"
#include "Messages.h"
#include "Morphometry.h"
#include "OutputFolder.h"
#include "Page.h"
#include "Pictures.h"
#include "Progress.h"
#include "ReadPoints.h"
#include "Report.h"
#include "ReportPage.h"
#include "Results.h"
#include "Signals.h"
#include "Tables.h"
#include "Verdict.h"

#include <vtkBoundarySamples.h>
#include <vtkCleanScan.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkImageBoundary.h>
#include <vtkMedialAxis.h>
#include <vtkMedialPartDecomposition.h>
#include <vtkMedialPrune.h>
#include <vtkNew.h>
#include <vtkPolarBalls.h>
#include <vtkPolyData.h>
#include <vtkPowerCrust.h>
#include <vtkSMPTools.h>
#include <vtkSimplifyShape.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <chrono>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>

namespace
{
void setImageProperties(vtkImageBoundary* boundary, const Arguments& arguments)
{
  if (arguments.iso || arguments.label)
  {
    boundary->SetSolid(arguments.iso ? vtkImageBoundary::ISO_VALUE : vtkImageBoundary::LABEL);
    boundary->SetIsoValue(arguments.iso.value_or(0));
    boundary->SetLabel(arguments.label.value_or(0));
  }
  boundary->SetFillCavities(arguments.fillCavities.value_or(boundary->GetFillCavities()));
  boundary->SetMinimumPieceVoxels(
    arguments.smallestPiece.value_or(boundary->GetMinimumPieceVoxels()));
  boundary->SetGaussianRadius(arguments.gaussian.value_or(boundary->GetGaussianRadius()));
  boundary->SetPieces(
    arguments.largestPiece ? vtkImageBoundary::LARGEST : vtkImageBoundary::FROM_SIZE);
}

void setProperties(vtkSimplifyShape* simplify, const Arguments& arguments)
{
  simplify->MakeUnprunedOn(); // for parts.vtp and parts.csv; --remove-parts names parts by them
  simplify->SetSchedule(arguments.schedule.c_str());
  simplify->SetAutomatic(arguments.automatic);
  simplify->SetMergeTolerance(arguments.mergeTolerance);
  simplify->SetUseTriangles(arguments.points ? vtkSimplifyShape::OFF : vtkSimplifyShape::AUTO);
  setImageProperties(simplify->GetImageBoundary(), arguments);
  vtkBoundarySamples* boundary = simplify->GetBoundarySamples();
  boundary->SetFineness(arguments.fineness > 0 ? arguments.fineness : boundary->GetFineness());
  boundary->SetSpacing(arguments.spacing);
  simplify->SetWrap(arguments.wrap);
  simplify->SetWrapWidth(arguments.wrapWidth);
  simplify->SetTrim(arguments.trim);
  simplify->SetSplitAtNecks(arguments.splitAtNecks);
  vtkMedialPrune* prune = simplify->GetMedialPrune();
  // PartId in surface.vtp is that in pruned.vtp. The filter's own parts can differ where necks are cut,
  // since it cuts the pruned axis again.
  simplify->GetPowerCrust()->SetAxisConnection(prune->GetOutputPort());
  prune->SetTopology(arguments.keepTopology ? vtkMedialPrune::COLLAPSE : vtkMedialPrune::NONE);
  for (int part : arguments.partsToRemove)
  {
    prune->AddPartToRemove(part);
  }
}

/// The samples of a scan without outliers and noise.
/// @throw InputError  there are too few
vtkSmartPointer<vtkPolyData> cleaned(vtkPolyData* samples, const std::string& file)
{
  vtkNew<vtkCleanScan> clean;
  clean->SetInputData(samples);
  clean->Update();
  if (clean->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InputError(file + ": " + messages::error());
  }
  messages::clear();
  return clean->GetOutput();
}

void watchStages(vtkSimplifyShape* simplify, Progress& progress)
{
  progress.watch("image", simplify->GetImageBoundary());
  progress.watch("samples", simplify->GetBoundarySamples());
  progress.watch("polar balls", simplify->GetPolarBalls());
  progress.watch("medial axis", simplify->GetMedialAxis());
  progress.watch("parts", simplify->GetUnprunedPartDecomposition());
  progress.watch("prune", simplify->GetMedialPrune());
  progress.watch("crust before", simplify->GetUnprunedPowerCrust());
  progress.watch("crust", simplify->GetPowerCrust());
}

/// @throw UsageError  a part to be removed does not exist
void checkPartsToRemove(vtkSimplifyShape* simplify, const Arguments& arguments)
{
  vtkDataObject* parts = simplify->GetUnprunedPartDecomposition()->GetOutput();
  if (!parts->GetFieldData()->HasArray("NumberOfParts"))
  {
    return; // this or an earlier stage has failed
  }
  const double count = fieldValue(parts, "NumberOfParts");
  for (int part : arguments.partsToRemove)
  {
    if (part >= count)
    {
      throw UsageError("--remove-parts: there is no part " + std::to_string(part) +
        "; this axis has parts 0 to " + std::to_string(static_cast<vtkIdType>(count) - 1));
    }
  }
}

/// Is to be called when the stages have run.
/// @throw UsageError  a part to be removed does not exist
/// @throw InputError  a stage can't use what it gets
void requireSuccess(vtkSimplifyShape* simplify, const Arguments& arguments)
{
  // If a part does not exist, pruning has failed. The message of this check says more.
  checkPartsToRemove(simplify, arguments);
  const std::string reason =
    *simplify->GetErrorMessage() ? simplify->GetErrorMessage() : messages::error();
  if (!reason.empty() || simplify->GetErrorCode() != vtkErrorCode::NoError)
  {
    const bool isUnclear = imageKind(arguments.input) != ImageKind::None && !arguments.iso &&
      !arguments.label && reason.find("choose") != std::string::npos;
    throw InputError(arguments.input + ": " +
      (reason.empty() ? "failed without a reason" : reason) +
      (isUnclear ? " (--label N or --iso X)" : ""));
  }
  messages::clear();
}

/// Reads the input and sets the filter up for it.
Input prepare(vtkSimplifyShape* simplify, const Arguments& arguments)
{
  if (arguments.threads > 0)
  {
    vtkSMPTools::Initialize(arguments.threads);
  }
  Input input = readInput(arguments.input, arguments.series, arguments.dropInvalid);
  if (arguments.clean)
  {
    input.samples = cleaned(input.samples, arguments.input);
  }
  simplify->SetInputDataObject(
    input.image ? static_cast<vtkDataObject*>(input.image) : input.samples);
  setProperties(simplify, arguments);
  return input;
}

Captions captionsOf(vtkSimplifyShape* simplify)
{
  const auto parts = [](vtkDataObject* axis) {
    const double count = fieldValue(axis, "NumberOfParts");
    return grouped(count) + (count == 1 ? " part" : " parts");
  };
  const double samples = fieldValue(simplify->GetBalls(), "NumberOfSamples");
  return { grouped(samples) + " samples", "medial axis",
    parts(simplify->GetUnprunedPartDecomposition()->GetOutput()),
    "pruned to " + parts(simplify->GetMedialPrune()->GetOutput()), "simplified surface" };
}

/// Draws what is published. If that fails, the results stay, without any picture.
void addPictures(vtkSimplifyShape* simplify, DrawingProcess& process, OutputFolder& folder)
{
  try
  {
    process.draw(pictureOrder(folder.path(), folder.draft(), captionsOf(simplify)));
    folder.publish(OutputFolder::Kept);
  }
  catch (const std::exception& error)
  {
    folder.discard();
    std::cerr << "warning: there are no pictures: " << error.what() << '\n';
  }
}

/// A file or folder without those above it.
std::string nameOf(const std::filesystem::path& input)
{
  return (input.has_filename() ? input : input.parent_path()).filename().string();
}

ExitCode simplify(const Arguments& arguments)
{
  const auto begin = std::chrono::steady_clock::now();
  std::optional<DrawingProcess> drawing;
  if (arguments.picture)
  {
    drawing.emplace("--picture", drawPictures);
  }
  std::optional<ReportPage> page;
  if (arguments.page)
  {
    page.emplace();
  }
  vtkNew<vtkSimplifyShape> filter;
  const Input input = prepare(filter, arguments);
  OutputFolder folder(arguments.output, arguments.input);
  Progress progress(arguments.quiet);
  watchStages(filter, progress);
  Results results(filter, folder, arguments);
  filter->Update();
  results.check();
  requireSuccess(filter, arguments);
  const double total =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() -
    results.seconds();
  results.writeRest();
  MeasuredObject object;
  if (arguments.morphometry)
  {
    object = morphometryOf(filter, arguments);
    folder.writeText(csv(object.row), "morphometry.csv");
  }
  if (page)
  {
    const bool isWhole = !arguments.bounds && arguments.margin == 0; // as on the page
    page->write(filter, { nameOf(arguments.input), arguments.unit, object.row },
      isWhole ? object.means.Get() : nullptr, progress, folder);
  }
  folder.writeText(report(filter, input, object.row, progress, total), "report.json");
  folder.publish(OutputFolder::Replaced);
  if (!arguments.quiet)
  {
    std::cout << summary(filter, input, arguments, results.axisTriangles(), total);
  }
  if (drawing)
  {
    addPictures(filter, *drawing, folder);
  }
  if (arguments.strict && !verdictOf(filter->GetOutput()).certified())
  {
    std::cerr << "SimplifyShape: the result is not certified; see verdict in " << arguments.output
              << "/report.json\n";
    return NotCertified;
  }
  return Done;
}

void requireCertified(bool isCertified, const Arguments& arguments)
{
  if (arguments.strict && !isCertified)
  {
    throw InputError("the result is not certified");
  }
}

/// The header and the row of one object of a cohort.
/// @throw UsageError, InputError  see simplify()
std::string measured(const Arguments& arguments)
{
  if (arguments.writesResults)
  {
    Arguments withRow = arguments;
    withRow.morphometry = true;
    requireCertified(simplify(withRow) == Done, arguments);
    return contentOf(arguments.output + "/morphometry.csv");
  }
  vtkNew<vtkSimplifyShape> filter;
  const Input input = prepare(filter, arguments);
  filter->SetMakeUnpruned(!arguments.partsToRemove.empty());
  filter->KeepAxisOff();
  filter->Update();
  requireSuccess(filter, arguments);
  requireCertified(verdictOf(filter->GetOutput()).certified(), arguments);
  return csv(morphometryOf(filter, arguments).row);
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
    signals::take("SimplifyShape");
    const Arguments arguments = parseArguments(argc, argv);
    if (arguments.help)
    {
      std::cout << usage();
      return Done;
    }
    messages::capture(arguments.quiet);
    return arguments.cohort.empty() ? simplify(arguments) : measureCohort(arguments, measured);
  }
  catch (const UsageError& error)
  {
    return fail(error, WrongUsage);
  }
  catch (const std::bad_alloc&)
  {
    return fail(InputError("there is not enough memory for this input; thin it out, or use a "
                           "machine with more memory"),
      UnusableInput);
  }
  catch (const std::filesystem::filesystem_error& error)
  {
    return fail(InputError(error.path1().string() + ": " + error.code().message()), UnusableInput);
  }
  catch (const std::exception& error) // InputError, ...
  {
    return fail(error, UnusableInput);
  }
}
