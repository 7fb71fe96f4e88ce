// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SharedBalls.h"

#include "Conversion/Balls.h"

#include <utility>

namespace medial
{
SharedBalls::SharedBalls(std::vector<SharedBalls**> readers)
  : Readers(std::move(readers))
{
  for (SharedBalls** reader : this->Readers)
  {
    *reader = this;
  }
}

SharedBalls::~SharedBalls()
{
  for (SharedBalls** reader : this->Readers)
  {
    *reader = nullptr;
  }
}

std::shared_ptr<const PolarBalls> SharedBalls::of(vtkUnstructuredGrid* input)
{
  if (this->Input != input || this->Time != input->GetMTime())
  {
    this->Input = nullptr;
    this->Balls = nullptr;
    this->Balls = ballsOf(input, nullptr);
    this->Input = input;
    this->Time = input->GetMTime();
  }
  return this->Balls;
}

std::shared_ptr<const PolarBalls> ballsOf(vtkUnstructuredGrid* input, SharedBalls* shared)
{
  return shared ? shared->of(input) : std::make_shared<const PolarBalls>(readPolarBalls(input));
}
}
