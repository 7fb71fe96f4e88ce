// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPowerCrust.h"

#include "Axis/AxisBetti.h"
#include "Axis/MedialAxis.h"
#include "Collections/Objects.h"
#include "Conversion/Axis.h"
#include "Conversion/Crust.h"
#include "Conversion/Parts.h"
#include "Conversion/Verdict.h"
#include "Conversion/Warnings.h"
#include "Crust/Verdict.h"
#include "Parts/BallShares.h"
#include "Parts/PartRanks.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"
#include "Pipeline/ReportWarnings.h"
#include "Pipeline/SharedBalls.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <optional>
#include <vector>

static_assert(vtkPowerCrust::CLEARANCE == static_cast<int>(medial::CrustRule::Clearance) &&
    vtkPowerCrust::INNER_ONLY == static_cast<int>(medial::CrustRule::InnerOnly) &&
    vtkPowerCrust::INNER_AND_OUTER == static_cast<int>(medial::CrustRule::InnerAndOuter),
  "the property Rule is cast to the core's enum");

namespace
{
/// Which balls are kept, the part that each counts for, and the topology of the axis. All empty, for
/// all inner balls and no parts, where there is no axis.
struct KeptBalls
{
  std::vector<char> Flags;
  std::vector<medial::Index> Parts;
  std::vector<medial::Index> Ranks; ///< of the parts
  std::optional<medial::Betti> Topology;

  KeptBalls(vtkPolyData* axisData, vtkUnstructuredGrid* balls)
  {
    if (!axisData)
    {
      return;
    }
    const medial::MedialAxis axis = medial::readMedialAxis(axisData);
    const std::vector<medial::Index> parts = medial::readParts(axisData);
    medial::checkSameBalls(axisData, balls);
    this->Flags = medial::keptBalls(axis);
    this->Topology = medial::bettiNumbers(axis.cells);
    if (!parts.empty())
    {
      this->Parts = medial::partOfBall(axis, parts);
      this->Ranks = medial::lowestRanks(parts, axis.cells.size(), medial::readRanks(axisData));
    }
  }
};

/// Adds what was found out on the cells of the axis and of the crust.
medial::Findings withCrust(
  medial::Findings findings, const KeptBalls& kept, const medial::Crust& crust)
{
  if (findings.axis)
  {
    findings.axis->pruned = *kept.Topology;
  }
  findings.crust = crust.betti;
  findings.closed = crust.closed;
  findings.manifold = crust.manifold;
  return findings;
}
}

vtkStandardNewMacro(vtkPowerCrust);
medialAbortMacro(vtkPowerCrust);

vtkPowerCrust::vtkPowerCrust()
{
  this->SetNumberOfInputPorts(2);
}

int vtkPowerCrust::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkPowerCrust::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkPowerCrust::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkDataObject* axes = vtkDataObject::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const auto balls = medial::ballsOf(input, this->Shared);
      vtkPolyData* axis = medial::axisOf(input, axes);
      execution.poll();
      const KeptBalls kept(axis, input);
      execution.poll();
      medial::Findings findings = medial::readFindings(input, axis);
      const medial::CrustOptions options{ static_cast<medial::CrustRule>(this->Rule),
        this->Clearance, this->MaximumRounds, kept.Topology };
      const medial::Crust crust = medial::powerCrust(*balls, kept.Flags, options, execution);
      medial::write(crust, kept.Parts, kept.Ranks, input, output);
      medial::addWarnings(output->GetFieldData(), findings.warnings); // the axis has more
      medial::reportWarnings(this, crust.warnings, { output });
      findings.warnings = medial::readWarnings(output->GetFieldData());
      const medial::Verdict verdict = medial::verdict(withCrust(findings, kept, crust));
      medial::write(verdict, output->GetFieldData());
      if (!verdict.certified)
      {
        vtkWarningMacro(<< medial::sentenceOf(verdict));
      }
    });
}

void vtkPowerCrust::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rule: " << this->Rule << "\n";
  os << indent << "Clearance: " << this->Clearance << "\n";
  os << indent << "MaximumRounds: " << this->MaximumRounds << "\n";
}
