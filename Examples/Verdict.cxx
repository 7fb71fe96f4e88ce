// SPDX-License-Identifier: BSD-3-Clause
#include "Verdict.h"

#include "Tables.h"

#include <vtkMedialAxis.h>
#include <vtkMedialPrune.h>
#include <vtkPolyData.h>
#include <vtkPowerCrust.h>
#include <vtkSimplifyShape.h>

#include <array>
#include <sstream>

namespace
{
/// The Betti numbers of a stage.
struct Topology
{
  const char* stage;
  std::array<double, 3> betti;
};

Topology topologyOf(const char* stage, vtkDataObject* output, const char* array)
{
  return { stage,
    { fieldValue(output, array, 0), fieldValue(output, array, 1), fieldValue(output, array, 2) } };
}

void compare(const Topology& before, const Topology& after, std::vector<std::string>& result)
{
  if (before.betti != after.betti)
  {
    const auto [pieces, tunnels, voids] = after.betti;
    const auto [oldPieces, oldTunnels, oldVoids] = before.betti;
    std::ostringstream text;
    text << "the " << after.stage << " has " << pieces << " pieces, " << tunnels << " tunnels, "
         << voids << " voids, the " << before.stage << " " << oldPieces << ", " << oldTunnels
         << ", " << oldVoids;
    result.push_back(text.str());
  }
}
}

std::vector<std::string> contradictions(vtkSimplifyShape* simplify)
{
  vtkPolyData* axisData = simplify->GetMedialAxis()->GetOutput();
  vtkMedialPrune* prune = simplify->GetMedialPrune();
  vtkPolyData* surfaceData = simplify->GetPowerCrust()->GetOutput();
  const Topology shape = topologyOf("power shape", axisData, "BettiPowerShape");
  const Topology axis = topologyOf("axis", axisData, "BettiAxis");
  const Topology pruned = topologyOf("pruned axis", prune->GetOutput(), "BettiAxis");
  const Topology surface = topologyOf("surface", surfaceData, "BettiCrust");
  std::vector<std::string> result;
  compare(shape, axis, result);
  if (prune->GetTopology() == vtkMedialPrune::COLLAPSE)
  {
    compare(axis, pruned, result);
  }
  compare(pruned, surface, result);
  if (fieldValue(surfaceData, "Closed") == 0)
  {
    result.emplace_back("the surface is not closed");
  }
  else if (fieldValue(surfaceData, "Manifold") == 0)
  {
    result.emplace_back("the surface is not a manifold");
  }
  return result;
}
