// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMMedialPartColors.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTransferFunctionManager.h"

#include <iterator>
#include <vector>

namespace
{
/// How many parts have a color of their own; those beyond are gray.
constexpr int NumberOfColors = 256;

/// Red, green, blue; taken again and again.
constexpr double Palette[][3] = { { 0.90, 0.38, 0.32 }, { 0.28, 0.53, 0.78 }, { 0.42, 0.70, 0.32 },
  { 0.95, 0.70, 0.25 }, { 0.58, 0.40, 0.72 }, { 0.22, 0.70, 0.68 }, { 0.94, 0.55, 0.72 },
  { 0.60, 0.42, 0.28 }, { 0.72, 0.78, 0.24 }, { 0.45, 0.45, 0.58 }, { 0.98, 0.85, 0.45 },
  { 0.62, 0.80, 0.93 } };
constexpr double Gray[] = { 0.75, 0.75, 0.75 };

/// One entry, number and color, for each part.
std::vector<double> colorsOfParts()
{
  std::vector<double> result;
  for (int part = 0; part < NumberOfColors; ++part)
  {
    const auto& color = Palette[part % std::size(Palette)];
    result.push_back(part);
    result.insert(result.end(), std::begin(color), std::end(color));
  }
  return result;
}
}

vtkStandardNewMacro(vtkSMMedialPartColors);

void vtkSMMedialPartColors::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* vtkNotUsed(xml), vtkMTimeType vtkNotUsed(time))
{
  vtkNew<vtkSMTransferFunctionManager> manager;
  vtkSMProxy* colors = manager->GetColorTransferFunction("PartId", proxy->GetSessionProxyManager());
  if (!colors || vtkSMPropertyHelper(colors, "ScalarRangeInitialized").GetAsInt() != 0)
  {
    return;
  }
  // Not as categories: ParaView refuses to make them of more than 32 values, with a dialog.
  const std::vector<double> points = colorsOfParts();
  vtkSMPropertyHelper(colors, "RGBPoints").Set(points.data(), static_cast<int>(points.size()));
  vtkSMPropertyHelper(colors, "ColorSpace").Set(0); // RGB
  vtkSMPropertyHelper(colors, "Discretize").Set(1);
  vtkSMPropertyHelper(colors, "NumberOfTableValues").Set(NumberOfColors);
  vtkSMPropertyHelper(colors, "AutomaticRescaleRangeMode").Set(vtkSMTransferFunctionManager::NEVER);
  vtkSMPropertyHelper(colors, "ScalarRangeInitialized").Set(1);
  vtkSMPropertyHelper(colors, "UseAboveRangeColor").Set(1);
  vtkSMPropertyHelper(colors, "AboveRangeColor").Set(Gray, 3);
  vtkSMPropertyHelper(colors, "NanColor").Set(Gray, 3);
  colors->UpdateVTKObjects();
}

void vtkSMMedialPartColors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
