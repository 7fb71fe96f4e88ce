// SPDX-License-Identifier: BSD-3-Clause
#ifndef StageChain_h
#define StageChain_h

#include "Base/Types.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPointSet;

namespace fuzz
{
/// The outputs of the stages that a later stage reads.
enum Kind
{
  Balls,
  Axis,
  Parts,
  Pruned,
  KindCount
};

const char* kindName(int kind);

/// All of one object, as the filters give them.
struct Stages
{
  std::string name;
  vtkSmartPointer<vtkPointSet> data[KindCount];
};

Stages stagesOf(const std::string& name, const std::vector<medial::Point>& samples);

/// Runs all filters that read what was changed, and what follows them up to the surface.
/// @param kind  of what was changed in `stages`
/// @return      what is wrong, a line for each fault; empty: each filter gave an error and empty
///              outputs, or what makes sense
///
/// Makes sense: finite points; corners that are points; an axis with cells; finite measures; a surface
/// that is closed, counted here and as it says itself, and encloses a positive volume. Whether this is the
/// axis or the surface of the object can't be known: an array whose values changed to other valid ones is
/// a valid file of another object.
std::string faultsOf(const Stages& stages, int kind);
}

#endif
