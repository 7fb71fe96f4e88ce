// SPDX-License-Identifier: BSD-3-Clause
#ifndef Verdict_h
#define Verdict_h

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkDataObject;

// What the filters say about their results, from the field data of an output. Only the surface has a
// verdict.

/// Something doubtful that a filter has found.
struct Warning
{
  std::string code;
  std::string text;
  double count = 0;
  std::optional<std::array<double, 3>> place;
  bool doubtsSolid = false;
};

std::vector<Warning> warningsOf(vtkDataObject* output);

/// Do all stages agree, and does nothing speak against the samples? See vtkPowerCrust.h.
struct Verdict
{
  std::string name; ///< "certified" or "not certified"
  std::vector<std::string> reasons;

  bool certified() const { return this->name == "certified"; }
};

Verdict verdictOf(vtkDataObject* surface);

/// The warning events of VTK that say what is in the output, too.
std::vector<std::string> eventsOf(vtkDataObject* output);

#endif
