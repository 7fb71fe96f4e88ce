// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMMedialPartColors
 * @brief   a colour of its own for each of the first parts
 *
 * An initialization helper: the description of a filter names it, and ParaView calls it for each new
 * filter. The first time it sets the colors of the array `PartRank` to those of
 * vtkMedialPartDecomposition::GetPartColor(). It does not change colors that the user has chosen.
 */

#ifndef vtkSMMedialPartColors_h
#define vtkSMMedialPartColors_h

#include "vtkMedialPartColorsModule.h" // for export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKMEDIALPARTCOLORS_EXPORT vtkSMMedialPartColors : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMMedialPartColors* New();
  vtkTypeMacro(vtkSMMedialPartColors, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType time) override;

protected:
  vtkSMMedialPartColors() = default;
  ~vtkSMMedialPartColors() override = default;

private:
  vtkSMMedialPartColors(const vtkSMMedialPartColors&) = delete;
  void operator=(const vtkSMMedialPartColors&) = delete;
};

#endif
