// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Images.h"

#include "Base/Errors.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Balls.h"
#include "Conversion/Cells.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace medial
{
namespace
{
constexpr std::size_t MostLabels = 30; // in a message

/// What values an image has.
struct Values
{
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  vtkIdType invalid = 0;   ///< NaN
  std::set<double> labels; ///< the different values, until there are more than MostLabels
};

/// Calls body(number) for each voxel.
template <typename Body>
void forVoxels(vtkDataArray* values, const Body& body)
{
  const auto walk = [&body](auto* array) {
    for (const auto value : vtk::DataArrayValueRange<1>(array))
    {
      body(static_cast<double>(value));
    }
  };
  if (!vtkArrayDispatch::Dispatch::Execute(values, walk))
  {
    walk(values);
  }
}

Values valuesOf(vtkDataArray* array)
{
  Values result;
  double last = std::numeric_limits<double>::quiet_NaN();
  forVoxels(array, [&](double value) {
    if (value == last)
    {
      return;
    }
    last = value;
    result.invalid += std::isnan(value) ? 1 : 0;
    result.least = std::min(result.least, value);
    result.most = std::max(result.most, value);
    if (result.labels.size() <= MostLabels && !std::isnan(value))
    {
      result.labels.insert(value);
    }
  });
  return result;
}

std::string rangeOf(const Values& values)
{
  return text(values.least, " ... ", values.most);
}

/// Few whole numbers are labels; others are told by their range.
bool areLabels(const Values& values)
{
  return values.labels.size() <= MostLabels &&
    std::all_of(values.labels.begin(), values.labels.end(),
      [](double value) { return value == std::floor(value); });
}

std::string inWords(const Values& values)
{
  if (!areLabels(values))
  {
    return "the values are " + rangeOf(values);
  }
  std::string list;
  for (const double label : values.labels)
  {
    list += text(list.empty() ? "" : ", ", label);
  }
  return "the labels are " + list;
}

/// The one label of an image with two values: the one that isn't 0, else the larger one.
SolidChoice onlyLabel(const Values& values)
{
  if (values.labels.size() != 2)
  {
    throw InvalidInput("which voxels are the solid? ", inWords(values), ": choose ",
      areLabels(values) ? "a label, or an iso value" : "an iso value between");
  }
  return { SolidChoice::Label,
    *values.labels.rbegin() == 0 ? *values.labels.begin() : *values.labels.rbegin() };
}

void check(const Values& values, const SolidChoice& choice)
{
  if (values.invalid > 0)
  {
    throw InvalidInput(values.invalid, " voxels have no number (NaN): give them a value");
  }
  if (choice.kind != SolidChoice::Label &&
    !(choice.value > values.least && choice.value <= values.most))
  {
    throw InvalidInput("no surface is at the iso value ", choice.value, ": ", inWords(values),
      "; choose one between");
  }
  if (choice.kind == SolidChoice::Label && values.labels.size() <= MostLabels &&
    values.labels.count(choice.value) == 0)
  {
    throw InvalidInput("no voxel has the label ", choice.value, ": ", inWords(values));
  }
}

/// @throw InvalidInput  the image is flat, or is nowhere
void checkGrid(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  if (std::min({ size[0], size[1], size[2] }) < 2)
  {
    throw InvalidInput("the image has ", size[0], " x ", size[1], " x ", size[2],
      " voxels: a solid needs an image with at least two in each direction");
  }
  const double* spacing = image->GetSpacing();
  const double* direction = image->GetDirectionMatrix()->GetData();
  const bool isFinite = std::all_of(image->GetOrigin(), image->GetOrigin() + 3,
                          [](double x) { return std::isfinite(x); }) &&
    std::all_of(spacing, spacing + 3, [](double x) { return std::isfinite(x) && x > 0; });
  if (!isFinite || !(std::abs(image->GetDirectionMatrix()->Determinant()) > 0) ||
    !std::all_of(direction, direction + 9, [](double x) { return std::isfinite(x); }))
  {
    throw InvalidInput("the image's spacing must be positive, its origin and direction finite and "
                       "not degenerate: mend its header");
  }
}

/// Where a point of the surface is in space.
Point inSpace(const Point& point, const ImageBoundary& boundary, vtkImageData* input)
{
  const int* extent = input->GetExtent();
  const Point voxel =
    point + Point(extent[0], extent[2], extent[4]) - Point::Constant(boundary.margin);
  Point place;
  input->TransformContinuousIndexToPhysicalPoint(voxel.data(), place.data());
  return place;
}

void addField(const ImageBoundary& boundary, const SolidChoice& choice, vtkImageData* input,
  vtkFieldData* field)
{
  passInput(input, field);
  const bool isLabel = choice.kind == SolidChoice::Label;
  addOne<vtkDoubleArray>(field, isLabel ? names::Label : names::IsoValue, choice.value);
  addBetti(field, names::BettiSegmentation, boundary.segmentation);
  addBetti(field, names::BettiBoundary, boundary.betti);
  addOne<vtkIdTypeArray>(field, names::PaddedVoxels, boundary.margin);
  addOne<vtkIdTypeArray>(field, names::FilledCavities, boundary.repairs.filledCavities);
  addOne<vtkIdTypeArray>(field, names::FilledVoxels, boundary.repairs.filledVoxels);
  addOne<vtkIdTypeArray>(field, names::DroppedPieces, boundary.repairs.droppedPieces);
  addOne<vtkIdTypeArray>(field, names::DroppedVoxels, boundary.repairs.droppedVoxels);
  field->AddArray(tuples<vtkIdTypeArray>(
    names::CutVoxels, 6, std::array<std::array<Index, 6>, 1>{ boundary.cut }));
}
}

VoxelMask readMask(vtkImageData* image, vtkDataArray* values, SolidChoice& choice)
{
  checkGrid(image);
  if (!values || values->GetNumberOfComponents() != 1)
  {
    throw InvalidInput("the solid needs an array with one number for each voxel, as point data; ",
      values ? text("'", values->GetName() ? values->GetName() : "", "' has ",
                 values->GetNumberOfComponents(), " for each")
             : std::string("there is none"));
  }
  if (values->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw InvalidInput("there are ", image->GetNumberOfPoints(), " voxels, but ",
      values->GetNumberOfTuples(), " values");
  }
  toIndex(image->GetNumberOfPoints(), "voxels");
  const Values found = valuesOf(values);
  choice = choice.kind == SolidChoice::Auto && found.invalid == 0 ? onlyLabel(found) : choice;
  check(found, choice);
  const int* size = image->GetDimensions();
  VoxelMask mask{ { size[0], size[1], size[2] }, {} };
  mask.inside.reserve(static_cast<std::size_t>(image->GetNumberOfPoints()));
  const bool isLabel = choice.kind == SolidChoice::Label;
  forVoxels(values, [&, chosen = choice.value](double value) {
    mask.inside.push_back(isLabel ? value == chosen : value >= chosen);
  });
  const auto solid = std::count(mask.inside.begin(), mask.inside.end(), 1);
  if (solid == 0 || solid == image->GetNumberOfPoints())
  {
    throw InvalidInput(solid == 0 ? "no" : "every", " voxel is of the solid: ", inWords(found),
      "; choose another label or iso value");
  }
  return mask;
}

Warnings warningsInSpace(const ImageBoundary& boundary, vtkImageData* input)
{
  Warnings result = boundary.warnings;
  for (Warning& warning : result)
  {
    if (warning.place)
    {
      warning.place = inSpace(*warning.place, boundary, input);
    }
  }
  return result;
}

void padExtent(int extent[6], int margin)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] -= margin;
    extent[2 * axis + 1] += margin;
  }
}

void write(const ImageBoundary& boundary, const SolidChoice& choice, vtkImageData* input,
  vtkPolyData* surface, vtkImageData* mask)
{
  // A mirrored image turns triangles over.
  std::vector<Triangle> triangles = boundary.surface.triangles;
  if (input->GetDirectionMatrix()->Determinant() < 0)
  {
    std::for_each(triangles.begin(), triangles.end(), [](Triangle& t) { std::swap(t[1], t[2]); });
  }
  std::vector<Point> places;
  for (const Point& point : boundary.surface.points)
  {
    places.push_back(inSpace(point, boundary, input));
  }
  surface->SetPoints(points(places));
  surface->SetPolys(cellArray(triangles));
  addField(boundary, choice, input, surface->GetFieldData());

  mask->CopyStructure(input);
  int extent[6];
  input->GetExtent(extent);
  padExtent(extent, boundary.margin);
  mask->SetExtent(extent);
  add<vtkUnsignedCharArray>(mask->GetPointData(), names::Mask, boundary.mask.inside);
  mask->GetPointData()->SetActiveScalars(names::Mask);
  addField(boundary, choice, input, mask->GetFieldData());
}
}
