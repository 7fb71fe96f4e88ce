// SPDX-License-Identifier: BSD-3-Clause
#ifndef StageTest_h
#define StageTest_h

#include "FilterTest.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <ostream>

/// The filters one by one, for tests of what all do alike.
namespace filterTest
{
/// A filter and which of its inputs to play with.
struct Stage
{
  const char* name;
  vtkAlgorithm* (*of)(Pipeline&);
  int port;
};

inline void PrintTo(const Stage& stage, std::ostream* stream)
{
  *stream << stage.name;
}

inline const Stage stages[] = {
  { "PolarBalls", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.balls; }, 0 },
  { "MedialAxis", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.axis; }, 0 },
  { "MedialPartDecomposition", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.parts; }, 0 },
  { "MedialPrune", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.prune; }, 0 },
  { "PowerCrust", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.crust; }, 0 },
  { "PowerCrustOfAxis", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.crust; }, 1 },
  { "Morphometry", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.morphometry; }, 0 },
  { "MorphometryOfAxis", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.morphometry; }, 1 },
  { "MorphometryOfSurface", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.morphometry; },
    2 },
  { "LocalThickness", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.thickness; }, 0 },
  { "LocalThicknessOfAxis", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.thickness; }, 2 },
  { "PlatesAndRods", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.elements; }, 0 },
  { "MedialCenterlines", [](auto& pipeline) -> vtkAlgorithm* { return pipeline.curves; }, 0 },
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

class Stages : public testing::TestWithParam<Stage>
{
};
}

#endif
