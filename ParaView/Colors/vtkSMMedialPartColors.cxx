// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMMedialPartColors.h"

#include "vtkMedialPartDecomposition.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTransferFunctionManager.h"

#include <vector>

namespace
{
/// How many parts have a color of their own; those beyond, very small ones, are gray.
constexpr int NumberOfColors = 4096;

/// One entry, number and color, for each part.
std::vector<double> colorsOfParts()
{
  std::vector<double> result;
  for (int part = 0; part < NumberOfColors; ++part)
  {
    double color[3];
    vtkMedialPartDecomposition::GetPartColor(part, color);
    result.push_back(part);
    result.insert(result.end(), color, color + 3);
  }
  return result;
}
}

vtkStandardNewMacro(vtkSMMedialPartColors);

void vtkSMMedialPartColors::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* vtkNotUsed(xml), vtkMTimeType vtkNotUsed(time))
{
  vtkNew<vtkSMTransferFunctionManager> manager;
  vtkSMProxy* colors =
    manager->GetColorTransferFunction("PartRank", proxy->GetSessionProxyManager());
  if (!colors || vtkSMPropertyHelper(colors, "ScalarRangeInitialized").GetAsInt() != 0)
  {
    return;
  }
  // Not as categories, which would give a legend: of more than 32 values in the data ParaView 5.11 refuses to
  // make them, with a dialog at each Apply, even where all are described here.
  const std::vector<double> points = colorsOfParts();
  double gray[3];
  vtkMedialPartDecomposition::GetPartColor(-1, gray);
  vtkSMPropertyHelper(colors, "RGBPoints").Set(points.data(), static_cast<int>(points.size()));
  vtkSMPropertyHelper(colors, "ColorSpace").Set(0); // RGB
  vtkSMPropertyHelper(colors, "Discretize").Set(1);
  vtkSMPropertyHelper(colors, "NumberOfTableValues").Set(NumberOfColors);
  vtkSMPropertyHelper(colors, "AutomaticRescaleRangeMode").Set(vtkSMTransferFunctionManager::NEVER);
  vtkSMPropertyHelper(colors, "ScalarRangeInitialized").Set(1);
  vtkSMPropertyHelper(colors, "UseAboveRangeColor").Set(1);
  vtkSMPropertyHelper(colors, "AboveRangeColor").Set(gray, 3);
  vtkSMPropertyHelper(colors, "NanColor").Set(gray, 3);
  colors->UpdateVTKObjects();
}

void vtkSMMedialPartColors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
