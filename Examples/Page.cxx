// SPDX-License-Identifier: BSD-3-Clause
#include "Page.h"

#include "Charts.h"
#include "Html.h"
#include "Json.h"
#include "PagePictures.h"
#include "PageStyle.h"
#include "Tables.h"
#include "ThicknessMap.h"
#include "Verdict.h"

#include <vtkBase64Utilities.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageBoundary.h>
#include <vtkMedialAxis.h>
#include <vtkMedialPartDecomposition.h>
#include <vtkMedialPrune.h>
#include <vtkMorphometry.h>
#include <vtkPointData.h>
#include <vtkPowerCrust.h>
#include <vtkSimplifyShape.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace
{
constexpr vtkIdType MostThinPlaces = 10;

std::string section(const std::string& title, const std::string& content)
{
  return element("section", '\n' + element("h2", title) + '\n' + content) + '\n';
}

std::string paragraph(const std::string& content)
{
  return element("p", content) + '\n';
}

std::string list(const std::vector<std::string>& items)
{
  std::string content = "\n";
  for (const std::string& item : items)
  {
    content += element("li", item) + '\n';
  }
  return element("ul", content) + '\n';
}

std::string warningItem(const Warning& warning)
{
  std::string text = element("code", escaped(warning.code)) + ": " + escaped(warning.text);
  if (warning.place)
  {
    const auto [x, y, z] = *warning.place;
    text += " One is at (" + measure(x) + ", " + measure(y) + ", " + measure(z) + ").";
  }
  return text;
}

/// Certified or not, why not, and what else is doubtful.
std::string verdict(vtkSimplifyShape* simplify)
{
  const Verdict verdict = verdictOf(simplify->GetOutput());
  std::string content = '\n' + element("h2", "Verdict: " + escaped(verdict.name)) + '\n';
  std::vector<std::string> items;
  if (verdict.certified())
  {
    content +=
      paragraph("All stages have the same topology, the surface is closed, and no warning says "
                "that the samples may not determine the solid.");
  }
  else
  {
    std::transform(
      verdict.reasons.begin(), verdict.reasons.end(), std::back_inserter(items), escaped);
    content += paragraph("Check the following before you rely on the numbers:") + list(items);
  }
  items.clear();
  const std::vector<Warning> warnings = warningsOf(simplify->GetOutput());
  std::transform(warnings.begin(), warnings.end(), std::back_inserter(items), warningItem);
  content += items.empty() ? paragraph("There are no warnings.")
                           : element("h3", "Warnings") + '\n' + list(items);
  return element(
           std::string("section class=\"verdict") + (verdict.certified() ? "" : " doubtful") + '"',
           content) +
    '\n';
}

std::string base64(const std::string& bytes)
{
  std::string result((bytes.size() + 2) / 3 * 4, '=');
  result.resize(vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
    bytes.size(), reinterpret_cast<unsigned char*>(result.data())));
  return result;
}

/// @param below  what follows the picture, such as a legend
std::string figure(const std::string& png, const std::string& alt, const std::string& caption,
  const std::string& below)
{
  return element("figure",
           "\n<img alt=\"" + alt + "\" src=\"data:image/png;base64," + base64(png) + "\">\n" +
             below + element("figcaption", caption) + '\n') +
    '\n';
}

double numberOfParts(vtkAlgorithm* stage)
{
  return fieldValue(stage->GetOutputDataObject(0), "NumberOfParts");
}

/// What grey means, where there is some.
std::string greyNote(vtkPolyData* surface)
{
  vtkDataArray* values = surface->GetPointData()->GetArray("Thickness");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    if (std::isnan(values->GetComponent(i, 0)))
    {
      return "; grey where no ball reaches, at sharp edges";
    }
  }
  return "";
}

std::string pictures(vtkSimplifyShape* simplify, const ThicknessMap& map, const PagePictures& drawn,
  const std::string& unit)
{
  if (!drawn.missing.empty())
  {
    return section(
      "Pictures", element("p", "There are no pictures: " + escaped(drawn.missing) + '.') + '\n');
  }
  const ChartLabels labels = { "Thickness", unit, "" };
  const std::string parts = countOf(numberOfParts(simplify->GetMedialPrune()));
  const std::string content =
    figure(drawn.surface, "The simplified surface, coloured by thickness",
      "Simplified surface" + greyNote(map.surface), legend("scale-surface", map.top(), labels)) +
    figure(drawn.axis, "The medial axis, coloured by thickness", "Medial axis, after pruning",
      legend("scale-axis", map.top(), labels)) +
    figure(drawn.parts, "The parts of the medial axis in a colour each",
      "Parts of the axis: " + parts + ", a colour each", "");
  return section("Pictures", element("div class=\"side\"", '\n' + content) + '\n');
}

std::string meanRow(const std::string& name, const VolumeMean& values)
{
  const auto cell = [&](double value) { return measure(value, values.largest); };
  return tableRow({ name, cell(values.mean), cell(values.deviation), cell(values.smallest),
    cell(values.largest), countOf(values.number) });
}

std::string histogramFigure(
  const VolumeMean& values, double top, const ChartLabels& labels, const std::string& caption)
{
  if (!(values.number > 0 && values.largest > 0))
  {
    return "";
  }
  return element("figure",
           '\n' + histogram(values.histogram, values.largest, values.mean, top, labels) +
             element("figcaption", caption) + '\n') +
    '\n';
}

std::string thickness(const ThicknessMap& map, const std::string& unit)
{
  const VolumeMean inside = volumeMean(map.means, "Thickness");
  const VolumeMean outside = volumeMean(map.means, "Separation");
  const std::string shareOf = "Share of the volume of the ";
  return section("Thickness and separation",
    paragraph("The thickness at a place is the diameter of the largest ball inside the solid that "
              "contains it; the "
              "separation that of the largest ball outside. Both are measured at points spread "
              "evenly over the volume "
              "of the solid before pruning, and over the gaps within its bounding box.") +
      htmlTable("", { "", "mean", "deviation", "smallest", "largest", "points" },
        { meanRow("Thickness", inside), meanRow("Separation", outside) }) +
      element("div class=\"side\"",
        '\n' +
          histogramFigure(inside, map.top(), { "Thickness", unit, "solid" },
            shareOf + "solid by thickness, in the colours of the pictures") +
          histogramFigure(
            outside, 0, { "Separation", unit, "gaps" }, shareOf + "gaps by separation")) +
      '\n');
}

std::string thinPlaces(vtkTable* places)
{
  const vtkIdType count = places->GetNumberOfRows(), shown = std::min(count, MostThinPlaces);
  if (count == 0)
  {
    return section("Thinnest places",
      paragraph("None was found: no wall or strut is a tenth thinner at a place than around it."));
  }
  auto* at = vtkDataArray::SafeDownCast(places->GetColumnByName("Place"));
  const double thickest = places->GetValueByName(shown - 1, "Thickness").ToDouble();
  double farthest = 0;
  for (vtkIdType i = 0; i < 3 * shown; ++i)
  {
    farthest = std::max(farthest, std::abs(at->GetComponent(i / 3, static_cast<int>(i % 3))));
  }
  std::vector<std::string> rows;
  for (vtkIdType row = 0; row < shown; ++row)
  {
    const auto value = [&](const char* column) {
      return places->GetValueByName(row, column).ToDouble();
    };
    rows.push_back(tableRow({ std::to_string(row + 1), measure(value("Thickness"), thickest),
      measure(at->GetComponent(row, 0), farthest), measure(at->GetComponent(row, 1), farthest),
      measure(at->GetComponent(row, 2), farthest), countOf(value("PartId")) }));
  }
  const std::string which = shown < count
    ? "The thinnest " + countOf(double(shown)) + " of " + countOf(double(count)) + " places"
    : "All " + countOf(double(count)) + " places";
  return section("Thinnest places",
    paragraph(which +
      " where a wall or strut is thinner than around it, by a tenth or more. Sharp edges are not "
      "counted. "
      "Parts have the numbers of <code>PartId</code> in <code>pruned.vtp</code>.") +
      htmlTable("", { "", "thickness", "x", "y", "z", "part" }, rows));
}

/// A unit like mm^-1 with its exponent raised.
std::string raised(const std::string& unit)
{
  const std::size_t mark = unit.rfind('^');
  return mark == std::string::npos
    ? escaped(unit)
    : escaped(unit.substr(0, mark)) + element("sup", escaped(unit.substr(mark + 1)));
}

/// The quantities of the standard, where they were asked for.
std::string morphometry(vtkTable* row, const std::string& unit)
{
  if (!row)
  {
    return "";
  }
  std::vector<std::string> rows;
  for (int i = 0; vtkMorphometry::GetQuantityName(i); ++i)
  {
    const char* name = vtkMorphometry::GetQuantityName(i);
    rows.push_back(tableRow({ escaped(name), measure(row->GetValueByName(0, name).ToDouble()),
      raised(vtkMorphometry::GetQuantityUnit(i, unit.c_str())),
      element("span class=\"meaning\"", escaped(vtkMorphometry::GetQuantityDescription(i))) }));
  }
  std::vector<std::string> items;
  const std::vector<Warning> warnings = warningsOf(row);
  std::transform(warnings.begin(), warnings.end(), std::back_inserter(items), warningItem);
  return section("Morphometry",
    paragraph(
      "Of the simplified solid, with the names of bone morphometry (Bouxsein et al. 2010).") +
      htmlTable("", { "quantity", "value", "unit", "" }, rows) +
      (items.empty() ? "" : element("h3", "Warnings") + '\n' + list(items)));
}

/// A row of Betti numbers; nothing where the stage has none.
std::string bettiRow(const std::string& stage, vtkDataObject* output, const char* array)
{
  if (!output || !output->GetFieldData()->HasArray(array))
  {
    return "";
  }
  return tableRow({ stage, countOf(fieldValue(output, array, 0)),
    countOf(fieldValue(output, array, 1)), countOf(fieldValue(output, array, 2)) });
}

std::string topology(vtkSimplifyShape* simplify)
{
  vtkDataObject* axis = simplify->GetMedialAxis()->GetOutput();
  return htmlTable("Topology", { "stage", "pieces", "tunnels", "voids" },
    { bettiRow("voxels", simplify->GetImageBoundary()->GetOutput(), "BettiSegmentation"),
      bettiRow("solid of the input", simplify->GetBalls(), "BettiSolid"),
      bettiRow("power shape", axis, "BettiPowerShape"), bettiRow("medial axis", axis, "BettiAxis"),
      bettiRow("pruned axis", simplify->GetMedialPrune()->GetOutput(), "BettiAxis"),
      bettiRow("simplified surface", simplify->GetOutput(), "BettiCrust") });
}

/// @param simplify  after an update
std::string sizes(vtkSimplifyShape* simplify)
{
  vtkDataObject *surface = simplify->GetOutput(), *samples = simplify->GetBalls();
  const double before = fieldValue(simplify->GetUnprunedPowerCrust()->GetOutput(), "Volume");
  const auto row = [](const char* name, const std::string& value) {
    return tableRow({ name, value });
  };
  return htmlTable("Sizes", {},
    { row("samples", countOf(fieldValue(samples, "NumberOfSamples"))),
      row("mean distance between samples", measure(fieldValue(surface, "SampleSpacing"))),
      row("parts before pruning", countOf(numberOfParts(simplify->GetUnprunedPartDecomposition()))),
      row("parts after pruning", countOf(numberOfParts(simplify->GetMedialPrune()))),
      row("pruning moved 99 % of the samples by at most", measure(fieldValue(surface, "MovedBy"))),
      row("pruning moved all samples by at most", measure(fieldValue(surface, "MovedAtMost"))),
      row("volume before pruning", measure(before)),
      row("volume after pruning", measure(fieldValue(surface, "Volume"))) });
}
}

std::string page(vtkSimplifyShape* simplify, const ThicknessMap& map, const PagePictures& drawn,
  const PageHead& head)
{
  const std::string name = escaped(head.name);
  const std::string units = head.unit.empty()
    ? "Lengths are in the unit of the input, volumes in that unit cubed."
    : "Lengths are in " + escaped(head.unit) + ", volumes in " + escaped(head.unit) + "&sup3;.";
  const std::string opening =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
    element("title", name + ": medial axis and thickness") + '\n' + element("style", PageStyle) +
    "\n</head>\n<body>\n";
  const std::string header = element("header",
    '\n' + element("h1", name) + '\n' +
      paragraph("Medial axis and thickness of this solid, made by SimplifyShape. " + units));
  const std::string footer = element("footer",
    '\n' +
      paragraph("Beside this page: <code>thickness.vtp</code>, the surface with its thickness, "
                "<code>pruned.vtp</code>, the axis with its parts, for ParaView; "
                "<code>report.json</code>, all "
                "figures for programs."));
  return opening + header + '\n' +
    element("main",
      '\n' + verdict(simplify) + pictures(simplify, map, drawn, head.unit) +
        thickness(map, head.unit) + thinPlaces(map.thinPlaces) +
        morphometry(head.morphometry, head.unit) +
        section("What was measured",
          element("div class=\"side\"", '\n' + sizes(simplify) + topology(simplify)) + '\n')) +
    '\n' + footer + "\n</body>\n</html>\n";
}
