// SPDX-License-Identifier: BSD-3-Clause
/**
 * The selection of Medial Prune in the panel: ParaView's own, but Copy Active Selection knows where the
 * selection was made. Ids of the input are copied; cells of the filter's own axis and removed cells are
 * translated to those of the input; what was selected elsewhere is refused with a message.
 * A description asks for it by panel_widget="medial_selection".
 */

#ifndef pqMedialSelection_h
#define pqMedialSelection_h

#include "pqProxyPropertyWidget.h"
#include "vtkSmartPointer.h"

class pqOutputPort;
class pqSelectionInputWidget;

class pqMedialSelection : public pqProxyPropertyWidget
{
  Q_OBJECT

public:
  pqMedialSelection(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

private:
  void copyActiveSelection();
  bool isInput(pqOutputPort* port) const;
  bool isOwnAxis(pqOutputPort* port) const;
  vtkSmartPointer<vtkSMProxy> ofInput(pqOutputPort* port) const;
  void refuse(const QString& selected);

  pqSelectionInputWidget* Copied = nullptr;
};

#endif
