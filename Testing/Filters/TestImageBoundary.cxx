// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageBoundary.h"

#include "FilterTest.h"

#include <Eigen/Geometry>

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{
using filterTest::arrays;
using filterTest::ErrorLog;
using filterTest::isEmpty;
using filterTest::onlyError;
using medial::Betti;
using medial::Point;

using Value = std::function<double(double x, double y, double z)>;

/// n^3 voxels with coordinates -1 ... 1 at their centres; from extent 3, 5, 7 on.
vtkSmartPointer<vtkImageData> image(int n, const Value& value)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetExtent(3, 3 + n - 1, 5, 5 + n - 1, 7, 7 + n - 1);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  const auto at = [n](int i) { return (2.0 * i + 1) / n - 1; };
  for (int i = 0; i < n * n * n; ++i)
  {
    values->InsertNextValue(value(at(i % n), at(i / n % n), at(i / (n * n))));
  }
  result->GetPointData()->SetScalars(values);
  return result;
}

double ball(double x, double y, double z)
{
  return std::hypot(x, y, z) < 0.7 ? 1 : 0;
}

double torus(double x, double y, double z)
{
  return std::hypot(std::hypot(x, y) - 0.55, z) < 0.25 ? 1 : 0;
}

/// A hollow ball with a small ball in it, and another one beside.
double islands(double x, double y, double z)
{
  const double r = std::hypot(x, y, z);
  return (r > 0.5 && r < 0.8) || r < 0.2 || std::hypot(x - 0.85, y - 0.85, z) < 0.15 ? 1 : 0;
}

/// n^3 voxels, each of the solid by chance.
/// @param share  of the voxels, in 256ths
/// @param state  of the random numbers, goes on
vtkSmartPointer<vtkImageData> randomImage(int n, unsigned share, unsigned& state)
{
  return image(n, [&](double, double, double) {
    state = state * 1664525 + 1013904223;
    return state >> 24 < share ? 1 : 0;
  });
}

vtkSmartPointer<vtkImageBoundary> filterOf(vtkImageData* input)
{
  auto result = vtkSmartPointer<vtkImageBoundary>::New();
  result->SetInputData(input);
  return result;
}

double field(vtkDataObject* data, const char* name, int component = 0)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, component);
}

Betti betti(vtkDataObject* data, const char* name)
{
  const auto number = [&](int k) { return static_cast<medial::Index>(field(data, name, k)); };
  return { number(0), number(1), number(2) };
}

std::string text(vtkDataObject* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? array->GetValue(0) : std::string();
}

double volume(vtkPolyData* surface)
{
  double result = 0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    surface->GetCellPoints(cell, size, corners);
    const Point a(surface->GetPoint(corners[0])), b(surface->GetPoint(corners[1])),
      c(surface->GetPoint(corners[2]));
    result += a.cross(b).dot(c) / 6;
  }
  return result;
}

void expectError(vtkImageBoundary* filter, const std::string& words)
{
  const std::string error = onlyError(filter);
  EXPECT_NE(error.find(words), std::string::npos) << error;
  EXPECT_TRUE(isEmpty(filter->GetOutput()));
}

TEST(ImageBoundary, HasTheArraysOfItsHeader)
{
  const auto filter = filterOf(image(20, torus));
  filter->Update();
  for (int port = 0; port < 2; ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    EXPECT_EQ(arrays(output->GetAttributesAsFieldData(vtkDataObject::FIELD)),
      (std::vector<std::string>{ "BettiBoundary idtype 3", "BettiSegmentation idtype 3",
        "CutVoxels idtype 6", "DroppedPieces idtype 1", "DroppedVoxels idtype 1",
        "FilledCavities idtype 1", "FilledVoxels idtype 1", "Label double 1",
        "PaddedVoxels idtype 1" }));
    EXPECT_EQ(betti(output, "BettiSegmentation"), (Betti{ 1, 1, 0 }));
    EXPECT_EQ(betti(output, "BettiBoundary"), (Betti{ 1, 1, 0 }));
    EXPECT_EQ(field(output, "Label"), 1);
    EXPECT_EQ(text(output, "WarningCode"), "");
  }
  auto* mask = vtkImageData::SafeDownCast(filter->GetOutputDataObject(1));
  const std::vector<int> extent(mask->GetExtent(), mask->GetExtent() + 6);
  EXPECT_EQ(
    extent, (std::vector<int>{ 0, 25, 2, 27, 4, 29 })); // by one voxel and the Gaussian's two
  EXPECT_STREQ(mask->GetPointData()->GetScalars()->GetName(), "Mask");
}

TEST(ImageBoundary, LiesWhereTheImageIs)
{
  for (const double mirror : { 1, -1 })
  {
    const auto input = image(30, ball);
    const double c = std::cos(0.4), s = std::sin(0.4);
    const double direction[] = { c, -s, 0, s, c, 0, 0, 0, mirror };
    input->GetDirectionMatrix()->DeepCopy(direction);
    input->SetSpacing(0.957, 0.957, 1.5);
    input->SetOrigin(-100, 20, 3000);
    const auto filter = filterOf(input);
    filter->Update();
    vtkPolyData* surface = filter->GetOutput();
    const double middle[] = { 3 + 14.5, 5 + 14.5, 7 + 14.5 };
    Point center;
    input->TransformContinuousIndexToPhysicalPoint(middle, center.data());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const Point away = Point(surface->GetPoint(i)) - center;
      const Point voxels((c * away.x() + s * away.y()) / 0.957,
        (-s * away.x() + c * away.y()) / 0.957, mirror * away.z() / 1.5);
      EXPECT_NEAR(voxels.norm(), 0.7 * 15, 0.7);
    }
    const auto inVoxels = filterOf(image(30, ball));
    inVoxels->Update();
    const double expected = volume(inVoxels->GetOutput()) * 0.957 * 0.957 * 1.5;
    EXPECT_NEAR(volume(surface), expected, 1e-6 * expected) << "mirrored: " << mirror;
  }
}

TEST(ImageBoundary, FillsAndDropsOnRequest)
{
  const auto filter = filterOf(image(40, islands));
  filter->SetFillCavities(0);
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 3, 0, 1 }));
  filter->SetFillCavities(VTK_ID_MAX);
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 2, 0, 0 }));
  EXPECT_EQ(field(filter->GetOutput(), "FilledCavities"), 1);
  filter->SetPiecesToLargest();
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 1, 0, 0 }));
  EXPECT_EQ(field(filter->GetOutput(), "DroppedPieces"), 1);
  EXPECT_GT(field(filter->GetOutput(), "DroppedVoxels"), 50);
}

TEST(ImageBoundary, ClosesACutSolidAndSaysSo)
{
  const auto filter =
    filterOf(image(20, [](double x, double y, double) { return std::hypot(x, y) < 0.6 ? 1 : 0; }));
  const ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 1, 0, 0 }));
  EXPECT_EQ(text(filter->GetOutput(), "WarningCode"), "cut_at_border");
  ASSERT_EQ(log.messages().size(), 1u);
  EXPECT_NE(log.messages()[0].find("(first k, last k)"), std::string::npos) << log.messages()[0];
  EXPECT_EQ(field(filter->GetOutput(), "CutVoxels", 3), 0);
  EXPECT_GT(field(filter->GetOutput(), "CutVoxels", 5), 90);
  EXPECT_EQ(field(filter->GetOutput(), "WarningPlace", 2), 7); // at the first k
  EXPECT_NEAR(field(filter->GetOutput(), "WarningPlace", 0), 3 + 9.5, 6);
  EXPECT_LT(filter->GetOutput()->GetBounds()[5], 7 + 20); // half a voxel beyond the last one
  filter->PadOff();
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 0, 0, 0 })); // open
}

TEST(ImageBoundary, TellsWhatSmoothingCosts)
{
  // A plate of one voxel with a rod of one voxel across a hole.
  const auto filter = filterOf(image(21, [](double x, double y, double z) {
    return std::abs(z) < 0.2 && std::hypot(x, y) < 0.9 &&
        (std::hypot(x, y) > 0.5 || (std::abs(x) < 0.04 && std::abs(z) < 0.04))
      ? 1
      : 0;
  }));
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiSegmentation"), (Betti{ 1, 2, 0 }));
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 1, 1, 0 }));
  EXPECT_EQ(text(filter->GetOutput(), "WarningCode"), "smoothed_topology");
  EXPECT_NEAR(field(filter->GetOutput(), "WarningPlace", 0), 3 + 10, 1); // on the rod
  EXPECT_NEAR(field(filter->GetOutput(), "WarningPlace", 2), 7 + 10, 1);
  filter->SetGaussianRadius(0);
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 1, 2, 0 }));
  EXPECT_EQ(text(filter->GetOutput(), "WarningCode"), "");
}

TEST(ImageBoundary, LeavesWallsThatSamplesCanResolve)
{
  // The Gaussian leaves barely anything of a wall of one voxel: its middle is at 0.52.
  const auto input = image(25, [](double x, double y, double z) {
    return std::hypot(x, y) < 0.9 && std::abs(z) < 0.04 ? 1 : 0;
  });
  vtkIdType voxels = 0;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    voxels += input->GetPointData()->GetScalars()->GetTuple1(i) > 0;
  }
  const auto filter = filterOf(input);
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 1, 0, 0 }));
  EXPECT_GT(volume(filter->GetOutput()), 0.4 * static_cast<double>(voxels));
}

TEST(ImageBoundary, DropsPiecesThatSmoothingTearsOff)
{
  // Two balls that a rod of one voxel connects.
  const auto filter = filterOf(image(31, [](double x, double y, double z) {
    return std::hypot(x + 0.5, y, z) < 0.4 || std::hypot(x - 0.6, y, z) < 0.3 ||
        (std::abs(x) < 0.5 && std::abs(y) < 0.03 && std::abs(z) < 0.03)
      ? 1
      : 0;
  }));
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiSegmentation"), (Betti{ 1, 0, 0 }));
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 2, 0, 0 }));
  filter->SetPiecesToLargest();
  filter->Update();
  EXPECT_EQ(betti(filter->GetOutput(), "BettiBoundary"), (Betti{ 1, 0, 0 }));
  EXPECT_LT(filter->GetOutput()->GetBounds()[1], 3 + 20);
}

TEST(ImageBoundary, IsClosedForRandomVoxels)
{
  unsigned state = 1;
  for (unsigned run = 0; run < 30; ++run)
  {
    const auto filter = filterOf(randomImage(8, 60 + 5 * run, state));
    const ErrorLog warnings(filter, vtkCommand::WarningEvent);
    filter->SetFillCavities(0);
    filter->SetMinimumPieceVoxels(1);
    filter->SetGaussianRadius(run % 2 == 0 ? 0 : 0.7);
    filter->Update();
    EXPECT_GT(betti(filter->GetOutput(), "BettiBoundary")[0], 0) << "run " << run;
  }
}

TEST(ImageBoundary, IsOnePieceOnRequestWhateverTheVoxels)
{
  unsigned state = 5;
  for (unsigned run = 0; run < 30; ++run)
  {
    const auto filter = filterOf(randomImage(12, 80 + 3 * run, state));
    const ErrorLog warnings(filter, vtkCommand::WarningEvent);
    filter->SetFillCavities(VTK_ID_MAX);
    filter->SetPiecesToLargest();
    filter->SetGaussianRadius(run % 2 == 0 ? 0 : 0.7);
    filter->Update();
    const Betti found = betti(filter->GetOutput(), "BettiBoundary");
    EXPECT_EQ(found, (Betti{ 1, found[1], 0 })) << "run " << run;
  }
}

TEST(ImageBoundary, TakesTheOnlyLabelOrAsks)
{
  const auto signedBall = image(12, [](double x, double y, double z) { return 5 * ball(x, y, z); });
  const auto filter = filterOf(signedBall);
  filter->Update();
  EXPECT_EQ(field(filter->GetOutput(), "Label"), 5);
  const auto labels =
    image(12, [](double x, double y, double z) { return ball(x, y, z) > 0 ? (x < 0 ? 2 : 7) : 0; });
  expectError(filterOf(labels), "the labels are 0, 2, 7: choose a label");
  const auto grey =
    image(12, [](double x, double y, double z) { return 100 * std::hypot(x, y, z) + 0.5; });
  expectError(filterOf(grey), ": choose an iso value between");
}

TEST(ImageBoundary, RefusesValuesThatTheImageLacks)
{
  const auto filter = filterOf(image(
    12, [](double x, double y, double z) { return ball(x, y, z) > 0 ? (x < 0 ? 2 : 7) : 0; }));
  filter->SetSolidToLabel();
  filter->SetLabel(3);
  expectError(filter, "no voxel has the label 3: the labels are 0, 2, 7");
  filter->SetSolidToIsoValue();
  filter->SetIsoValue(8);
  expectError(filter, "no surface is at the iso value 8");
  filter->SetIsoValue(0);
  expectError(filter, "no surface is at the iso value 0");
  filter->SetIsoValue(7);
  filter->Update();
  EXPECT_EQ(field(filter->GetOutput(), "IsoValue"), 7);
}

TEST(ImageBoundary, RefusesWhatIsNoSolid)
{
  const auto constant = filterOf(image(4, [](double, double, double) { return 3; }));
  expectError(constant, "the labels are 3");
  constant->SetSolidToLabel();
  constant->SetLabel(3);
  expectError(constant, "every voxel is of the solid");
  const auto specks = filterOf(
    image(12, [](double x, double y, double z) { return std::hypot(x, y, z) < 0.2 ? 1 : 0; }));
  expectError(specks, "the largest has 8");
  // A row of voxels, which the Gaussian leaves nothing of.
  const auto row = filterOf(image(
    61, [](double x, double y, double z) { return std::hypot(x, y) < 0.01 && std::abs(z) < 0.9; }));
  expectError(row, "thinner than its smoothing");
  row->SetGaussianRadius(0);
  row->Update();
  EXPECT_EQ(betti(row->GetOutput(), "BettiBoundary"), (Betti{ 1, 0, 0 }));
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  expectError(
    filterOf(image(12, [&](double x, double y, double z) { return ball(x, y, z) > 0 ? nan : 0; })),
    "have no number (NaN)");
}

TEST(ImageBoundary, RefusesWhatIsNoVolume)
{
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(10, 10, 1);
  flat->AllocateScalars(VTK_SHORT, 1);
  expectError(filterOf(flat), "10 x 10 x 1");
  vtkNew<vtkImageData> colors;
  colors->SetDimensions(3, 3, 3);
  colors->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  expectError(filterOf(colors), "has 3 for each");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 3, 3);
  expectError(filterOf(bare), "there is none");
  const auto squeezed = image(12, ball);
  squeezed->SetSpacing(1, 0, 1);
  expectError(filterOf(squeezed), "spacing");
}

TEST(ImageBoundary, TakesTheArrayThatIsNamed)
{
  const auto input = image(12, [](double, double, double) { return 0; });
  vtkNew<vtkShortArray> labels;
  labels->SetName("Labels");
  labels->SetNumberOfValues(input->GetNumberOfPoints());
  const auto source = image(12, ball);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    labels->SetValue(
      i, static_cast<short>(source->GetPointData()->GetScalars()->GetComponent(i, 0)));
  }
  input->GetPointData()->AddArray(labels);
  const auto filter = filterOf(input);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Labels");
  filter->Update();
  const auto other = filterOf(source);
  other->Update();
  EXPECT_TRUE(filterTest::same(filter->GetOutput(), other->GetOutput()));
}
}
