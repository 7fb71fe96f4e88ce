// SPDX-License-Identifier: BSD-3-Clause
// What every filter does alike: resume from files, name what is wrong with arrays, survive damage.
#include "StageTest.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace
{
using filterTest::Alone;
using filterTest::boxPipeline;
using filterTest::ErrorLog;
using filterTest::failed;
using filterTest::onlyError;
using filterTest::same;
using filterTest::Stage;
using filterTest::Stages;

/// An array that a filter reads.
struct Needed
{
  int attributes;
  std::string name;
  double tooLarge; ///< no number of anything; 0: not an array of whole numbers
};

double tooLargeFor(vtkDataArray* array)
{
  return array->GetDataType() == VTK_UNSIGNED_CHAR ? 255
    : array->GetDataType() == VTK_DOUBLE           ? 0
                                                   : 2147483647.;
}

/// Does the stage refuse an input without this array, by its name? Else it does not need it.
bool isNeeded(const Stage& stage, int attributes, const char* name)
{
  Alone alone(stage);
  alone.input()->GetAttributesAsFieldData(attributes)->RemoveArray(name);
  alone.input()->Modified();
  const ErrorLog log(alone.filter());
  alone.filter()->Update();
  EXPECT_LE(log.messages().size(), 1u) << name;
  const bool isRefused = !log.messages().empty();
  if (isRefused)
  {
    const std::string quoted = "'" + std::string(name) + "'";
    EXPECT_NE(log.messages()[0].find(quoted), std::string::npos) << log.messages()[0];
  }
  return isRefused;
}

/// The arrays of numbers that a stage needs, found by taking away one after another.
std::vector<Needed> arraysNeeded(const Stage& stage)
{
  std::vector<Needed> result;
  const Alone alone(stage);
  for (const int attributes : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::FIELD })
  {
    vtkFieldData* data = alone.input()->GetAttributesAsFieldData(attributes);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      if (data->GetArray(i) && isNeeded(stage, attributes, data->GetArrayName(i)))
      {
        result.push_back({ attributes, data->GetArrayName(i), tooLargeFor(data->GetArray(i)) });
      }
    }
  }
  return result;
}

const std::vector<Needed>& needed(const Stage& stage)
{
  static std::map<std::string, std::vector<Needed>> known;
  const auto found = known.find(stage.name);
  return found != known.end() ? found->second : known[stage.name] = arraysNeeded(stage);
}

const char* kindOf(const Needed& array)
{
  return array.attributes == vtkDataObject::POINT ? "point array '"
    : array.attributes == vtkDataObject::CELL     ? "cell array '"
                                                  : "field array '";
}

/// For each array that the filter reads, a run with a change of it: what the filter then says must
/// name the array, and what its maker is.
template <typename Change>
void expectRefusal(const Stage& stage, const Change& change, const std::string& says)
{
  for (const Needed& array : needed(stage))
  {
    SCOPED_TRACE(array.name);
    Alone alone(stage);
    vtkFieldData* data = alone.input()->GetAttributesAsFieldData(array.attributes);
    if (!change(data, array))
    {
      continue;
    }
    alone.input()->Modified();
    const std::string error = onlyError(alone.filter());
    EXPECT_NE(error.find(std::string(kindOf(array)) + array.name + "'"), error.npos) << error;
    EXPECT_NE(error.find("take the output of vtk"), error.npos) << error;
    EXPECT_NE(error.find(says), error.npos) << error;
  }
}

TEST_P(Stages, GiveTheSameFromTheirInputInAFile)
{
  Alone alone(this->GetParam());
  vtkAlgorithm* model = this->GetParam().of(boxPipeline());
  for (int port = 0; port < model->GetTotalNumberOfInputConnections(); ++port)
  {
    alone.setInput(port, filterTest::writtenAndRead(model->GetInputDataObject(port, 0)));
  }
  alone.filter()->Update();
  for (int port = 0; port < model->GetNumberOfOutputPorts(); ++port)
  {
    SCOPED_TRACE(port);
    EXPECT_TRUE(same(alone.filter()->GetOutputDataObject(port), model->GetOutputDataObject(port)));
  }
}

TEST_P(Stages, GiveOutputThatFilesKeep)
{
  vtkAlgorithm* filter = this->GetParam().of(boxPipeline());
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    SCOPED_TRACE(port);
    vtkDataObject* output = filter->GetOutputDataObject(port);
    EXPECT_TRUE(same(filterTest::writtenAndRead(output), output));
  }
}

TEST_P(Stages, PassFieldDataOn)
{
  Alone alone(Stage{ this->GetParam().name, this->GetParam().of, 0 });
  vtkNew<vtkStringArray> note;
  note->SetName("Note");
  note->InsertNextValue("kept");
  alone.input()->GetFieldData()->AddArray(note);
  alone.filter()->Update();
  EXPECT_EQ(alone.filter()->GetOutputDataObject(0)->GetFieldData()->GetAbstractArray("Note"), note);
}

TEST_P(Stages, LeaveTheirInputAsItIs)
{
  Alone alone(this->GetParam());
  vtkSmartPointer<vtkDataObject> before;
  before.TakeReference(alone.input()->NewInstance());
  before->DeepCopy(alone.input());
  alone.filter()->Update();
  EXPECT_TRUE(same(alone.input(), before));
}

TEST_P(Stages, DontDependOnThreads)
{
  Alone alone(this->GetParam());
  vtkSMPTools::Initialize(1);
  alone.filter()->Update();
  vtkSMPTools::Initialize(0);
  vtkAlgorithm* model = this->GetParam().of(boxPipeline());
  EXPECT_TRUE(same(alone.filter()->GetOutputDataObject(0), model->GetOutputDataObject(0)));
}

TEST_P(Stages, NeedArraysOfTheirInput)
{
  const std::vector<Needed>& arrays = needed(this->GetParam());
  const bool isFirst = std::string(this->GetParam().name) == "PolarBalls"; // of any points
  EXPECT_EQ(arrays.empty(), isFirst);
  for (const int attributes : { vtkDataObject::POINT, vtkDataObject::FIELD })
  {
    EXPECT_EQ(std::any_of(arrays.begin(), arrays.end(),
                [=](const Needed& array) { return array.attributes == attributes; }),
      !isFirst);
  }
}

TEST_P(Stages, NameAnArrayThatIsMissing)
{
  expectRefusal(
    this->GetParam(),
    [](vtkFieldData* data, const Needed& array) {
      data->RemoveArray(array.name.c_str());
      return true;
    },
    "there is no ");
}

TEST_P(Stages, NameAnArrayOfText)
{
  expectRefusal(
    this->GetParam(),
    [](vtkFieldData* data, const Needed& array) {
      vtkNew<vtkStringArray> text;
      text->SetName(array.name.c_str());
      text->SetNumberOfValues(data->GetAbstractArray(array.name.c_str())->GetNumberOfTuples());
      data->AddArray(text);
      return true;
    },
    "no numbers in ");
}

TEST_P(Stages, NameAnArrayThatIsTooShort)
{
  expectRefusal(
    this->GetParam(),
    [](vtkFieldData* data, const Needed& array) {
      vtkAbstractArray* values = data->GetAbstractArray(array.name.c_str());
      values->SetNumberOfTuples(values->GetNumberOfTuples() - 1);
      // Others are then too long for these, see NameAListWhoseOffsetsDontFit.
      return array.name != "Samples" && array.name != "BallSamples" && array.name != "BallOwner";
    },
    "entries instead of ");
}

TEST_P(Stages, NameAnArrayWithOtherComponents)
{
  expectRefusal(
    this->GetParam(),
    [](vtkFieldData* data, const Needed& array) {
      vtkAbstractArray* values = data->GetAbstractArray(array.name.c_str());
      const vtkIdType count = values->GetNumberOfTuples();
      values->SetNumberOfComponents(values->GetNumberOfComponents() + 1);
      values->SetNumberOfTuples(count);
      return true;
    },
    "components instead of ");
}

TEST_P(Stages, NameAnArrayOfFractionsWhereIdsAreNeeded)
{
  expectRefusal(
    this->GetParam(),
    [](vtkFieldData* data, const Needed& array) {
      vtkNew<vtkDoubleArray> fractions;
      fractions->DeepCopy(data->GetArray(array.name.c_str()));
      data->AddArray(fractions);
      return array.tooLarge != 0;
    },
    "must hold whole numbers");
}

TEST_P(Stages, NameAnArrayWithAnIdOfNothing)
{
  expectRefusal(
    this->GetParam(),
    [](vtkFieldData* data, const Needed& array) {
      data->GetArray(array.name.c_str())->SetComponent(0, 0, array.tooLarge);
      return array.tooLarge != 0;
    },
    "has the value ");
}

TEST_P(Stages, NameAnArrayWithANegativeId)
{
  expectRefusal(
    this->GetParam(),
    [](vtkFieldData* data, const Needed& array) {
      data->GetArray(array.name.c_str())->SetComponent(0, 0, -2);
      return array.tooLarge > 255; // -2 can't be stored in the others
    },
    "has the value -2 at 0");
}

TEST_P(Stages, NameAnArrayThatIsNotFinite)
{
  expectRefusal(
    this->GetParam(),
    [](vtkFieldData* data, const Needed& array) {
      data->GetArray(array.name.c_str())->SetComponent(0, 0, std::nan(""));
      return array.tooLarge == 0;
    },
    "has the value ");
}

TEST_P(Stages, NameAnArrayOfTheUsersThatIsTooShort)
{
  if (std::string(this->GetParam().name) == "PolarBalls")
  {
    return; // it passes on field data alone
  }
  for (const int attributes : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    Alone alone(this->GetParam());
    vtkNew<vtkDoubleArray> mine;
    mine->SetName("Mine");
    mine->SetNumberOfTuples(3);
    mine->Fill(0);
    alone.input()->GetAttributesAsFieldData(attributes)->AddArray(mine);
    alone.input()->Modified();
    const std::string error = onlyError(alone.filter());
    EXPECT_NE(error.find("array 'Mine' has 3 entries instead of "), error.npos) << error;
    EXPECT_TRUE(failed(alone.filter()));
  }
}

/// A cell gets other corners, an array another value: each may make sense or not.
void damage(vtkPointSet* data, const Stage& stage, std::mt19937& random)
{
  const auto below = [&random](vtkIdType end) {
    return static_cast<vtkIdType>(random() % std::max<vtkIdType>(end, 1));
  };
  const std::vector<Needed>& names = needed(stage);
  const Needed& array = names[below(static_cast<vtkIdType>(names.size()))];
  vtkDataArray* values =
    data->GetAttributesAsFieldData(array.attributes)->GetArray(array.name.c_str());
  const vtkIdType place = below(values->GetNumberOfTuples());
  const int component = static_cast<int>(below(values->GetNumberOfComponents()));
  const double candidates[] = { -1, 0, 1, 2, 1e300, -5, std::nan(""),
    static_cast<double>(below(data->GetNumberOfPoints())),
    values->GetComponent(below(values->GetNumberOfTuples()), component) };
  values->SetComponent(place, component, candidates[below(9)]);

  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  auto* surface = vtkPolyData::SafeDownCast(data);
  vtkCellArray* cells = grid ? grid->GetCells() : surface->GetPolys();
  vtkDataArray* corners = cells->GetConnectivityArray();
  const vtkIdType corner = below(corners->GetNumberOfTuples());
  corners->SetComponent(corner, 0, static_cast<double>(below(data->GetNumberOfPoints() + 1)));
}

TEST_P(Stages, SurviveDamage)
{
  // Fewer where everything is slow, under sanitizers.
  const char* fewer = std::getenv("MEDIAL_TEST_DAMAGES");
  const unsigned damages = fewer ? std::strtoul(fewer, nullptr, 10) : 40;
  for (unsigned seed = 0; seed < damages && !needed(this->GetParam()).empty(); ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    Alone alone(this->GetParam());
    for (unsigned i = 0; i <= seed % 4; ++i)
    {
      damage(vtkPointSet::SafeDownCast(alone.input()), this->GetParam(), random);
    }
    alone.input()->Modified();
    const ErrorLog log(alone.filter());
    alone.filter()->Update();
    EXPECT_LE(log.messages().size(), 1u);
    EXPECT_TRUE(log.messages().empty() || failed(alone.filter()));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Stages, testing::ValuesIn(filterTest::stages),
  [](const testing::TestParamInfo<Stage>& info) { return std::string(info.param.name); });
}
