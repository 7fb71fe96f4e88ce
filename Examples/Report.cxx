// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "Arguments.h"
#include "Json.h"
#include "Morphometry.h"
#include "Progress.h"
#include "ReadPoints.h"
#include "Tables.h"
#include "Verdict.h"

#include <vtkBoundarySamples.h>
#include <vtkFieldData.h>
#include <vtkImageBoundary.h>
#include <vtkMedialAxis.h>
#include <vtkMedialPartDecomposition.h>
#include <vtkMedialPrune.h>
#include <vtkPolarBalls.h>
#include <vtkPolyData.h>
#include <vtkPowerCrust.h>
#include <vtkSimplifyShape.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <cctype>
#include <initializer_list>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace
{
std::vector<std::string> bettiNumbers(vtkDataObject* output, const char* array)
{
  return { number(fieldValue(output, array, 0)), number(fieldValue(output, array, 1)),
    number(fieldValue(output, array, 2)) };
}

std::string bettiList(vtkDataObject* output, const char* array)
{
  return "[" + joined(bettiNumbers(output, array), ", ") + "]";
}

/// As a JSON string, with a small first letter like the keys: "triangleCount".
std::string measureName(int measure)
{
  std::string name = vtkMedialPrune::GetMeasureName(measure);
  name[0] = static_cast<char>(std::tolower(name[0]));
  return '"' + name + '"';
}

std::string iterations(vtkTable* history)
{
  std::vector<std::string> rows;
  for (vtkIdType row = 0; row < history->GetNumberOfRows(); ++row)
  {
    const auto value = [&](const char* column) {
      return history->GetValueByName(row, column).ToDouble();
    };
    const bool byHand = value("ByHand") != 0;
    rows.push_back(inBraces({
      { "measure", byHand ? "\"byHand\"" : measureName(static_cast<int>(value("Measure"))) },
      { "threshold", byHand ? "null" : number(value("Threshold")) },
      { "partsBefore", number(value("PartsBefore")) },
      { "partsAfter", number(value("PartsAfter")) },
      { "removed", number(value("Removed")) },
      { "refused", number(value("Refused")) },
    }));
  }
  return rowsOf(rows);
}

std::string verdict(vtkSimplifyShape* simplify)
{
  const Verdict verdict = verdictOf(simplify->GetOutput());
  std::vector<std::string> reasons;
  for (const std::string& reason : verdict.reasons)
  {
    reasons.push_back(quoted(reason));
  }
  return inBraces(
    { { "name", quoted(verdict.name) }, { "differs", "[" + joined(reasons, ", ") + "]" } });
}

std::string place(const Warning& warning)
{
  if (!warning.place)
  {
    return "null";
  }
  const auto [x, y, z] = *warning.place;
  return "[" + joined({ number(x), number(y), number(z) }, ", ") + "]";
}

std::string warnings(vtkSimplifyShape* simplify)
{
  std::vector<std::string> rows;
  for (const Warning& warning : warningsOf(simplify->GetOutput()))
  {
    rows.push_back(inBraces({
      { "code", quoted(warning.code) },
      { "text", quoted(warning.text) },
      { "count", number(warning.count) },
      { "place", place(warning) },
      { "doubtsSolid", truth(warning.doubtsSolid) },
    }));
  }
  return rowsOf(rows);
}

std::string balls(vtkSimplifyShape* simplify)
{
  vtkDataObject* output = simplify->GetBalls();
  return inBraces({
    { "inner", number(fieldValue(output, "NumberOfInnerBalls")) },
    { "outer", number(fieldValue(output, "NumberOfOuterBalls")) },
    { "hidden", number(fieldValue(output, "NumberOfHiddenBalls")) },
    { "offAxis",
      number(fieldValue(simplify->GetMedialAxis()->GetOutput(), "NumberOfOffAxisBalls")) },
  });
}

/// Were the triangles of the input sampled?
bool isSampled(vtkSimplifyShape* simplify)
{
  return simplify->GetBalls()->GetFieldData()->HasArray("BettiSolid");
}

/// The polygons of the input, or of the surface of the solid in an image.
double polygonCount(vtkSimplifyShape* simplify, const Input& input)
{
  return double(input.image ? simplify->GetImageBoundary()->GetOutput()->GetNumberOfPolys()
                            : input.samples->GetNumberOfPolys());
}

std::string source(vtkSimplifyShape* simplify, const Input& input)
{
  return input.image ? "\"image\"" : isSampled(simplify) ? "\"triangles\"" : "\"points\"";
}

/// What was done with the voxels of an image.
std::string image(vtkSimplifyShape* simplify, const Input& input)
{
  if (!input.image)
  {
    return "null";
  }
  vtkDataObject* surface = simplify->GetImageBoundary()->GetOutput();
  const auto value = [surface](const char* name) {
    return surface->GetFieldData()->HasArray(name) ? number(fieldValue(surface, name)) : "null";
  };
  std::vector<std::string> cut;
  for (int side = 0; side < 6; ++side)
  {
    cut.push_back(number(fieldValue(surface, "CutVoxels", side)));
  }
  return inBraces({
    { "isoValue", value("IsoValue") },
    { "label", value("Label") },
    { "filledCavities", value("FilledCavities") },
    { "filledVoxels", value("FilledVoxels") },
    { "droppedPieces", value("DroppedPieces") },
    { "droppedVoxels", value("DroppedVoxels") },
    { "paddedVoxels", value("PaddedVoxels") },
    { "cutVoxels", "[" + joined(cut, ", ") + "]" },
    { "boundary", bettiList(surface, "BettiBoundary") },
  });
}

/// What was taken from a scan.
std::string cleaning(vtkSimplifyShape* simplify)
{
  vtkDataObject* balls = simplify->GetBalls();
  if (!balls->GetFieldData()->HasArray("NoiseBefore"))
  {
    return "null";
  }
  return inBraces({
    { "noiseBefore", number(fieldValue(balls, "NoiseBefore")) },
    { "noiseAfter", number(fieldValue(balls, "NoiseAfter")) },
    { "outliers", number(fieldValue(balls, "DroppedOutliers")) },
    { "thinned", number(fieldValue(balls, "ThinnedSamples")) },
    { "thinning", number(fieldValue(balls, "Thinning")) },
    { "smoothingRounds", number(fieldValue(balls, "SmoothingRounds")) },
  });
}

/// How the triangles were sampled.
std::string sampling(vtkSimplifyShape* simplify, const Input& input)
{
  if (!isSampled(simplify))
  {
    return "null";
  }
  vtkDataObject* samples = simplify->GetBalls();
  return inBraces({
    { "polygons", number(polygonCount(simplify, input)) },
    { "volume", number(fieldValue(samples, "SolidVolume")) },
    { "area", number(fieldValue(samples, "SolidArea")) },
    { "mergedPoints", number(fieldValue(samples, "MergedPoints")) },
    { "droppedPolygons", number(fieldValue(samples, "DroppedPolygons")) },
    { "filledHoles", number(fieldValue(samples, "FilledHoles")) },
    { "refinementRounds", number(fieldValue(samples, "RefinementRounds")) },
  });
}

std::string betti(vtkSimplifyShape* simplify, const Input& input)
{
  return inBraces({
    { "segmentation",
      input.image ? bettiList(simplify->GetImageBoundary()->GetOutput(), "BettiSegmentation")
                  : "null" },
    { "solid", isSampled(simplify) ? bettiList(simplify->GetBalls(), "BettiSolid") : "null" },
    { "powerShape", bettiList(simplify->GetMedialAxis()->GetOutput(), "BettiPowerShape") },
    { "axis", bettiList(simplify->GetMedialAxis()->GetOutput(), "BettiAxis") },
    { "pruned", bettiList(simplify->GetMedialPrune()->GetOutput(), "BettiAxis") },
    { "crust", bettiList(simplify->GetPowerCrust()->GetOutput(), "BettiCrust") },
  });
}

std::string times(vtkSimplifyShape* simplify, const Progress& progress, double total)
{
  vtkAlgorithm *whole = simplify->GetUnprunedPowerCrust(), *pruned = simplify->GetPowerCrust();
  return inBraces({
    { "image", seconds(progress.seconds(simplify->GetImageBoundary())) },
    { "samples", seconds(progress.seconds(simplify->GetBoundarySamples())) },
    { "polarBalls", seconds(progress.seconds(simplify->GetPolarBalls())) },
    { "medialAxis", seconds(progress.seconds(simplify->GetMedialAxis())) },
    { "parts", seconds(progress.seconds(simplify->GetUnprunedPartDecomposition())) },
    { "prune", seconds(progress.seconds(simplify->GetMedialPrune())) },
    { "crust", seconds(progress.seconds(whole) + progress.seconds(pruned)) },
    { "total", seconds(total) },
  });
}

std::string scheduleLines(vtkSimplifyShape* simplify)
{
  vtkTable* history = vtkTable::SafeDownCast(simplify->GetMedialPrune()->GetOutputDataObject(1));
  std::ostringstream out;
  for (vtkIdType row = 0; row < history->GetNumberOfRows(); ++row)
  {
    const auto value = [&](const char* column) {
      return history->GetValueByName(row, column).ToDouble();
    };
    const std::string word = history->GetValueByName(row, "Word").ToString();
    out << "  " << std::left << std::setw(10) << word << grouped(value("PartsBefore")) << " -> "
        << grouped(value("PartsAfter")) << " parts";
    if (value("Refused") > 0)
    {
      out << ", " << grouped(value("Refused")) << " kept";
    }
    out << '\n';
  }
  return out.str();
}

std::string surfaceLine(vtkSimplifyShape* simplify)
{
  vtkPolyData* surface = simplify->GetPowerCrust()->GetOutput();
  vtkPolyData* whole = simplify->GetUnprunedPowerCrust()->GetOutput();
  const double spacing = fieldValue(surface, "SampleSpacing");
  std::ostringstream out;
  out << "  surface   " << grouped(surface->GetNumberOfPolys()) << " faces, "
      << (fieldValue(surface, "Closed") != 0 ? "closed" : "NOT CLOSED") << ", " << std::fixed
      << std::setprecision(2) << 100 * fieldValue(surface, "Volume") / fieldValue(whole, "Volume")
      << " % of the volume before, moved by " << fieldValue(surface, "MovedBy") / spacing
      << " spacings at 99 % of the samples, " << fieldValue(surface, "MovedAtMost") / spacing
      << " at most\n";
  return out.str();
}

std::string bettiLine(vtkSimplifyShape* simplify)
{
  vtkDataObject* axis = simplify->GetMedialAxis()->GetOutput();
  std::string line = "  Betti     ";
  if (isSampled(simplify))
  {
    line += "solid " + joined(bettiNumbers(simplify->GetBalls(), "BettiSolid"), " ") + ", ";
  }
  line += "power shape " + joined(bettiNumbers(axis, "BettiPowerShape"), " ");
  line += ", axis " + joined(bettiNumbers(axis, "BettiAxis"), " ");
  line +=
    ", pruned " + joined(bettiNumbers(simplify->GetMedialPrune()->GetOutput(), "BettiAxis"), " ");
  line +=
    ", surface " + joined(bettiNumbers(simplify->GetPowerCrust()->GetOutput(), "BettiCrust"), " ");
  const Verdict verdict = verdictOf(simplify->GetOutput());
  line += verdict.certified() ? ": certified\n" : ": NOT CERTIFIED\n";
  for (const std::string& reason : verdict.reasons)
  {
    line += "            " + reason + '\n';
  }
  return line;
}

std::string warningLines(vtkSimplifyShape* simplify)
{
  std::ostringstream out;
  for (const Warning& warning : warningsOf(simplify->GetOutput()))
  {
    out << "  warning   " << warning.text;
    if (warning.place)
    {
      const auto [x, y, z] = *warning.place;
      out << " One is at (" << x << ", " << y << ", " << z << ").";
    }
    out << '\n';
  }
  return out.str();
}
}

std::string report(vtkSimplifyShape* simplify, const Input& input, vtkTable* morphometry,
  const Progress& progress, double total)
{
  vtkDataObject *samples = simplify->GetBalls(), *surface = simplify->GetPowerCrust()->GetOutput();
  vtkDataObject* axis = simplify->GetMedialAxis()->GetOutput();
  vtkDataObject* parts = simplify->GetUnprunedPartDecomposition()->GetOutput();
  vtkDataObject* whole = simplify->GetUnprunedPowerCrust()->GetOutput();
  return "{\n  " +
    object(
      {
        { "source", source(simplify, input) },
        { "image", image(simplify, input) },
        { "samples", number(fieldValue(samples, "NumberOfSamples")) },
        { "sampling", sampling(simplify, input) },
        { "cleaning", cleaning(simplify) },
        { "duplicates", number(fieldValue(samples, "NumberOfDuplicates")) },
        { "mergeTolerance", number(fieldValue(samples, "MergeTolerance")) },
        { "invalid", number(double(input.invalid)) },
        { "invalidPolygons", number(double(input.invalidPolygons)) },
        { "balls", balls(simplify) },
        { "betti", betti(simplify, input) },
        { "certificate", truth(fieldValue(axis, "Certificate") != 0) },
        { "verdict", verdict(simplify) },
        { "warnings", warnings(simplify) },
        { "fallback", truth(fieldValue(axis, "Fallback") != 0) },
        { "filledGaps", number(fieldValue(axis, "FilledGaps")) },
        { "iterations",
          iterations(vtkTable::SafeDownCast(simplify->GetMedialPrune()->GetOutputDataObject(1))) },
        { "parts", number(fieldValue(parts, "NumberOfParts")) },
        { "volume",
          inBraces({
            { "crustBefore", number(fieldValue(whole, "Volume")) },
            { "crustAfter", number(fieldValue(surface, "Volume")) },
          }) },
        { "moved",
          inBraces({
            { "percentile99", number(fieldValue(surface, "MovedBy")) },
            { "largest", number(fieldValue(surface, "MovedAtMost")) },
            { "spacing", number(fieldValue(surface, "SampleSpacing")) },
          }) },
        { "morphometry", morphometryJson(morphometry) },
        { "seconds", times(simplify, progress, total) },
        { "peakMemoryMiB", number(peakMemoryMiB()) },
      },
      ",\n  ") +
    "\n}\n";
}

std::string summary(vtkSimplifyShape* simplify, const Input& input, const Arguments& arguments,
  vtkIdType axisTriangles, double total)
{
  vtkDataObject* samples = simplify->GetBalls();
  std::ostringstream out;
  out << arguments.input << ": " << grouped(fieldValue(samples, "NumberOfSamples")) << " samples"
      << (isSampled(simplify) ? " on " + grouped(polygonCount(simplify, input)) + " polygons" : "")
      << (input.invalid > 0 ? ", " + grouped(double(input.invalid)) + " invalid ones dropped" : "")
      << (input.invalidPolygons > 0
             ? ", with " + grouped(double(input.invalidPolygons)) + " polygons at them"
             : "")
      << "\n"
      << "  balls     " << grouped(fieldValue(samples, "NumberOfInnerBalls")) << " inner, "
      << grouped(fieldValue(samples, "NumberOfOuterBalls")) << " outer\n"
      << "  axis      " << grouped(double(axisTriangles)) << " triangles in "
      << grouped(fieldValue(simplify->GetUnprunedPartDecomposition()->GetOutput(), "NumberOfParts"))
      << " parts\n"
      << scheduleLines(simplify) << surfaceLine(simplify) << bettiLine(simplify)
      << warningLines(simplify) << "  " << std::fixed << std::setprecision(1) << total << " s, "
      << std::setprecision(0) << peakMemoryMiB() << " MiB; results in " << arguments.output
      << "/\n";
  return out.str();
}

std::string grouped(double count)
{
  std::string digits = std::to_string(static_cast<long long>(count));
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
  {
    digits.insert(i, ",");
  }
  return digits;
}
