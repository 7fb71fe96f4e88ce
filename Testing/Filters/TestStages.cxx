// SPDX-License-Identifier: BSD-3-Clause
// What every filter does alike: resume from files, name what is wrong with arrays, survive damage,
// report progress, stop, and give everything in the first piece.
#include "FilterTest.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
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

#include <cmath>
#include <limits>
#include <random>

namespace
{
using filterTest::boxPipeline;
using filterTest::ErrorLog;
using filterTest::failed;
using filterTest::isEmpty;
using filterTest::onlyError;
using filterTest::same;

/// A filter and which of its inputs to play with.
struct Stage
{
  const char* name;
  vtkAlgorithm* (*of)(filterTest::Pipeline&);
  int port;
};

void PrintTo(const Stage& stage, std::ostream* stream)
{
  *stream << stage.name;
}

const Stage stages[] = {
  { "PolarBalls", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.balls; }, 0 },
  { "MedialAxis", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.axis; }, 0 },
  { "MedialPartDecomposition", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.parts; }, 0 },
  { "MedialPrune", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.prune; }, 0 },
  { "PowerCrust", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.crust; }, 0 },
  { "PowerCrustOfAxis", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.crust; }, 1 },
};

/// A filter as in the pipeline of the small box, with copies of its inputs in place of filters.
class Alone
{
public:
  explicit Alone(const Stage& aStage)
    : Port(aStage.port)
  {
    vtkAlgorithm* model = aStage.of(boxPipeline());
    this->Filter.TakeReference(vtkAlgorithm::SafeDownCast(model->NewInstance()));
    for (int port = 0; port < model->GetTotalNumberOfInputConnections(); ++port)
    {
      this->setInput(port, model->GetInputDataObject(port, 0));
    }
  }

  void setInput(int port, vtkDataObject* data)
  {
    vtkSmartPointer<vtkDataObject> input;
    input.TakeReference(data->NewInstance());
    input->DeepCopy(data);
    this->Filter->SetInputDataObject(port, input);
  }

  vtkAlgorithm* filter() const { return this->Filter; }
  vtkDataObject* input() const { return this->Filter->GetInputDataObject(this->Port, 0); }

private:
  vtkSmartPointer<vtkAlgorithm> Filter;
  int Port;
};

/// An array that a filter reads.
struct Needed
{
  int attributes;
  const char* name;
  double tooLarge; ///< nothing to be found there; 0: any number will do
};

constexpr double Huge = 2e9;

const std::vector<Needed>& needed(const Stage& stage)
{
  static const std::vector<Needed> none;
  static const std::vector<Needed> ofBalls = {
    { vtkDataObject::POINT, "Radius", 0 },
    { vtkDataObject::POINT, "Side", 3 },
    { vtkDataObject::POINT, "TouchesGuard", 2 },
    { vtkDataObject::POINT, "Volume", 0 },
    { vtkDataObject::FIELD, "Samples", 0 },
    { vtkDataObject::FIELD, "DuplicateOf", Huge },
    { vtkDataObject::FIELD, "SampleInnerBall", Huge },
    { vtkDataObject::FIELD, "SampleOuterBall", Huge },
    { vtkDataObject::FIELD, "SamplingQuality", 0 },
    { vtkDataObject::FIELD, "SampleSpacing", 0 },
    { vtkDataObject::FIELD, "BallSampleOffsets", Huge },
    { vtkDataObject::FIELD, "BallSamples", Huge },
  };
  static const std::vector<Needed> ofAxis = {
    { vtkDataObject::POINT, "Radius", 0 },
    { vtkDataObject::POINT, "BallId", Huge },
    { vtkDataObject::CELL, "PolygonId", 2147483647. },
    { vtkDataObject::CELL, "SiteSamples", 2147483647. },
    { vtkDataObject::FIELD, "BallOwner", Huge },
    { vtkDataObject::FIELD, "BallVolume", 0 },
    { vtkDataObject::FIELD, "BettiPowerShape", 2147483647. },
    { vtkDataObject::FIELD, "BettiAxis", 2147483647. },
    { vtkDataObject::FIELD, "Certificate", 2 },
    { vtkDataObject::FIELD, "Fallback", 2 },
    { vtkDataObject::FIELD, "Kappa", 0 },
  };
  const std::string name = stage.name;
  return name == "PolarBalls"                      ? none
    : name == "MedialAxis" || name == "PowerCrust" ? ofBalls
                                                   : ofAxis;
}

const char* kindOf(const Needed& array)
{
  return array.attributes == vtkDataObject::POINT ? "point array '"
    : array.attributes == vtkDataObject::CELL     ? "cell array '"
                                                  : "field array '";
}

class Stages : public testing::TestWithParam<Stage>
{
public:
  /// For each array that the filter reads, a run with a change of it: what the filter then says must
  /// name the array, and what its maker is.
  template <typename Change>
  void expectRefusal(const Change& change, const std::string& says)
  {
    for (const Needed& array : needed(this->GetParam()))
    {
      SCOPED_TRACE(array.name);
      Alone alone(this->GetParam());
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
};

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

TEST_P(Stages, NameAnArrayThatIsMissing)
{
  this->expectRefusal(
    [](vtkFieldData* data, const Needed& array) {
      data->RemoveArray(array.name);
      return true;
    },
    "there is no ");
}

TEST_P(Stages, NameAnArrayOfText)
{
  this->expectRefusal(
    [](vtkFieldData* data, const Needed& array) {
      vtkNew<vtkStringArray> text;
      text->SetName(array.name);
      text->SetNumberOfValues(data->GetAbstractArray(array.name)->GetNumberOfTuples());
      data->AddArray(text);
      return true;
    },
    "no numbers in ");
}

TEST_P(Stages, NameAnArrayThatIsTooShort)
{
  this->expectRefusal(
    [](vtkFieldData* data, const Needed& array) {
      vtkAbstractArray* values = data->GetAbstractArray(array.name);
      values->SetNumberOfTuples(values->GetNumberOfTuples() - 1);
      const std::string name = array.name;
      // Others are then too long for these, see NameAListWhoseOffsetsDontFit.
      return name != "Samples" && name != "BallSamples" && name != "BallOwner";
    },
    "entries instead of ");
}

TEST_P(Stages, NameAnArrayWithOtherComponents)
{
  this->expectRefusal(
    [](vtkFieldData* data, const Needed& array) {
      vtkAbstractArray* values = data->GetAbstractArray(array.name);
      const vtkIdType count = values->GetNumberOfTuples();
      values->SetNumberOfComponents(values->GetNumberOfComponents() + 1);
      values->SetNumberOfTuples(count);
      return true;
    },
    "components instead of ");
}

TEST_P(Stages, NameAnArrayOfFractionsWhereIdsAreNeeded)
{
  this->expectRefusal(
    [](vtkFieldData* data, const Needed& array) {
      vtkNew<vtkDoubleArray> fractions;
      fractions->DeepCopy(data->GetArray(array.name));
      data->AddArray(fractions);
      return array.tooLarge != 0;
    },
    "must hold whole numbers");
}

TEST_P(Stages, NameAnArrayWithAnIdOfNothing)
{
  this->expectRefusal(
    [](vtkFieldData* data, const Needed& array) {
      data->GetArray(array.name)->SetComponent(0, 0, array.tooLarge);
      return array.tooLarge != 0;
    },
    "has the value ");
}

TEST_P(Stages, NameAnArrayWithANegativeId)
{
  this->expectRefusal(
    [](vtkFieldData* data, const Needed& array) {
      data->GetArray(array.name)->SetComponent(0, 0, -2);
      return array.tooLarge > 3; // -2 can't be stored in the others
    },
    "has the value -2 at 0");
}

TEST_P(Stages, NameAnArrayThatIsNotFinite)
{
  this->expectRefusal(
    [](vtkFieldData* data, const Needed& array) {
      data->GetArray(array.name)->SetComponent(0, 0, std::nan(""));
      return array.tooLarge == 0;
    },
    "has the value ");
}

TEST_P(Stages, ReportProgressThatGrows)
{
  Alone alone(this->GetParam());
  std::vector<double> reports;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&reports);
  listener->SetCallback([](vtkObject*, unsigned long, void* list, void* done) {
    static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(done));
  });
  alone.filter()->AddObserver(vtkCommand::ProgressEvent, listener);
  alone.filter()->Update();
  EXPECT_GE(reports.size(), 4u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_GE(reports.front(), 0);
  EXPECT_EQ(reports.back(), 1);
}

/// Stops a filter at its second report of progress that is neither start nor end.
vtkSmartPointer<vtkCallbackCommand> stopper()
{
  auto result = vtkSmartPointer<vtkCallbackCommand>::New();
  result->SetCallback([](vtkObject* filter, unsigned long, void*, void* done) {
    const double progress = *static_cast<double*>(done);
    if (progress > 0 && progress < 1)
    {
      static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
    }
  });
  return result;
}

TEST_P(Stages, StopWithoutAnErrorAndRunAgain)
{
  Alone alone(this->GetParam());
  const ErrorLog log(alone.filter());
  const unsigned long tag = alone.filter()->AddObserver(vtkCommand::ProgressEvent, stopper());
  alone.filter()->Update();
  EXPECT_TRUE(log.messages().empty()) << testing::PrintToString(log.messages());
  EXPECT_EQ(alone.filter()->GetErrorCode(), 0u);
  for (int port = 0; port < alone.filter()->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_TRUE(isEmpty(alone.filter()->GetOutputDataObject(port)));
  }
  alone.filter()->RemoveObserver(tag);
  alone.filter()->Modified();
  alone.filter()->Update();
  vtkAlgorithm* model = this->GetParam().of(boxPipeline());
  EXPECT_TRUE(same(alone.filter()->GetOutputDataObject(0), model->GetOutputDataObject(0)));
}

TEST_P(Stages, GiveEverythingInTheFirstPiece)
{
  Alone alone(this->GetParam());
  vtkAlgorithm* model = this->GetParam().of(boxPipeline());
  for (int port = 0; port < model->GetNumberOfOutputPorts(); ++port)
  {
    SCOPED_TRACE(port);
    alone.filter()->UpdatePiece(0, 2, 0);
    EXPECT_TRUE(same(alone.filter()->GetOutputDataObject(port), model->GetOutputDataObject(port)));
    alone.filter()->UpdatePiece(1, 2, 0);
    EXPECT_TRUE(isEmpty(alone.filter()->GetOutputDataObject(port)));
  }
}

TEST_P(Stages, DescribeThemselves)
{
  std::ostringstream text;
  this->GetParam().of(boxPipeline())->Print(text);
  EXPECT_NE(text.str().find("AbortExecute"), std::string::npos);
}

/// A cell gets other corners, an array another value: each may make sense or not.
void damage(vtkPointSet* data, const Stage& stage, std::mt19937& random)
{
  const auto below = [&random](vtkIdType end) {
    return std::uniform_int_distribution<vtkIdType>(0, std::max<vtkIdType>(end - 1, 0))(random);
  };
  const std::vector<Needed>& names = needed(stage);
  const Needed& array = names[below(static_cast<vtkIdType>(names.size()))];
  vtkDataArray* values = data->GetAttributesAsFieldData(array.attributes)->GetArray(array.name);
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
  corners->SetComponent(below(corners->GetNumberOfTuples()), 0,
    static_cast<double>(below(data->GetNumberOfPoints() + 1)));
}

TEST_P(Stages, SurviveDamage)
{
  for (unsigned seed = 0; seed < 40 && !needed(this->GetParam()).empty(); ++seed)
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

INSTANTIATE_TEST_SUITE_P(All, Stages, testing::ValuesIn(stages),
  [](const testing::TestParamInfo<Stage>& info) { return std::string(info.param.name); });

TEST(StoppedPipeline, IsEmptyToItsEndWithoutAnError)
{
  filterTest::Pipeline pipeline(filterTest::cloud(filterTest::smallBox().samples));
  const ErrorLog ofBalls(pipeline.balls), ofAxis(pipeline.axis), ofCrust(pipeline.crust);
  pipeline.balls->AddObserver(vtkCommand::ProgressEvent, stopper());
  pipeline.crust->Update();
  EXPECT_TRUE(ofBalls.messages().empty());
  EXPECT_TRUE(ofAxis.messages().empty()) << testing::PrintToString(ofAxis.messages());
  EXPECT_TRUE(ofCrust.messages().empty()) << testing::PrintToString(ofCrust.messages());
  EXPECT_TRUE(isEmpty(pipeline.crust->GetOutput()));
}
}
