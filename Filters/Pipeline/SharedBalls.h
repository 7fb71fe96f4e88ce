// SPDX-License-Identifier: BSD-3-Clause
#ifndef SharedBalls_h
#define SharedBalls_h

#include "Balls/PolarBalls.h"

#include "vtkType.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <vector>

namespace medial
{
/// What readPolarBalls() has made of the balls that several filters inside another one read: they are read and
/// checked once, and again only when their arrays have changed.
class SharedBalls
{
public:
  /// @param readers  where the filters find it, as long as it exists
  explicit SharedBalls(std::vector<SharedBalls**> readers);
  ~SharedBalls();
  SharedBalls(const SharedBalls&) = delete;
  SharedBalls& operator=(const SharedBalls&) = delete;

  std::shared_ptr<const PolarBalls> of(vtkUnstructuredGrid* input);

private:
  std::vector<SharedBalls**> Readers;
  vtkWeakPointer<vtkUnstructuredGrid> Input;
  vtkMTimeType Time = 0;
  std::shared_ptr<const PolarBalls> Balls;
};

/// The balls of the input, from those that are shared if there are such.
std::shared_ptr<const PolarBalls> ballsOf(vtkUnstructuredGrid* input, SharedBalls* shared);
}

#endif
