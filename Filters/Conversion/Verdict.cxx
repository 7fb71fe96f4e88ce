// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Verdict.h"

#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Remedies.h"
#include "Conversion/Warnings.h"

#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace medial
{
Findings readFindings(vtkUnstructuredGrid* balls, vtkPolyData* axis)
{
  Findings result;
  vtkFieldData* ballField = balls->GetFieldData();
  const Arrays ballArrays(ballField, "field", TakePolarBalls);
  result.powerShape = ballArrays.betti(names::BettiPowerShape);
  if (ballArrays.has(names::BettiSolid))
  {
    result.solid = ballArrays.betti(names::BettiSolid);
  }
  result.warnings = readWarnings(ballField);
  if (axis)
  {
    const Arrays field(axis->GetFieldData(), "field", TakeMedialAxis);
    result.axis = { field.betti(names::BettiUnprunedAxis), field.betti(names::BettiAxis),
      field.flag(names::TopologyKept) };
    const Warnings added = readWarnings(axis->GetFieldData());
    result.warnings.insert(result.warnings.end(), added.begin(), added.end());
  }
  return result;
}

void write(const Verdict& verdict, vtkFieldData* field)
{
  addTexts(field, names::Verdict, { nameOf(verdict) });
  if (!verdict.reasons.empty()) // some formats of VTK can't read back arrays without an entry
  {
    addTexts(field, names::VerdictReasons, verdict.reasons);
  }
}
}
