// SPDX-License-Identifier: BSD-3-Clause
#include "pqMedialSelection.h"

#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionInputWidget.h"
#include "pqSelectionManager.h"
#include "vtkNew.h"
#include "vtkPVSelectionInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"

#include <QMessageBox>
#include <QPushButton>

namespace
{
using Proxy = vtkSmartPointer<vtkSMSourceProxy>;

Proxy newProxy(vtkSMProxy* model, const char* group, const char* name)
{
  Proxy result;
  result.TakeReference(
    vtkSMSourceProxy::SafeDownCast(model->GetSessionProxyManager()->NewProxy(group, name)));
  return result;
}

/// The selection of a port as ids of its cells or points, evaluated with all its expressions.
/// @param array  instead of the ids, the values that this array has there; nullptr: ids
vtkSmartPointer<vtkSelection> evaluated(pqOutputPort* port, const char* array)
{
  const Proxy conversion = newProxy(port->getSourceProxy(), "filters", "ConvertSelection");
  vtkSMPropertyHelper(conversion, "Input").Set(port->getSelectionInput());
  vtkSMPropertyHelper(conversion, "DataInput").Set(port->getSourceProxy(), port->getPortNumber());
  vtkSMPropertyHelper(conversion, "OutputType")
    .Set(array ? vtkSelectionNode::VALUES : vtkSelectionNode::INDICES);
  if (array)
  {
    vtkSMPropertyHelper(conversion, "ArrayNames").Set(array);
  }
  conversion->UpdateVTKObjects();
  conversion->UpdatePipeline();
  vtkNew<vtkPVSelectionInformation> information;
  conversion->GatherInformation(information);
  return information->GetSelection();
}

/// Are all nodes lists of cells?
bool isOfCells(vtkSelection* selection)
{
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    if (selection->GetNode(i)->GetFieldType() != vtkSelectionNode::CELL)
    {
      return false;
    }
  }
  return selection->GetNumberOfNodes() > 0;
}

vtkSmartPointer<vtkSMProxy> copied(pqOutputPort* port)
{
  vtkSMSourceProxy* selection = port->getSelectionInput();
  Proxy result = newProxy(selection, selection->GetXMLGroup(), selection->GetXMLName());
  result->Copy(selection);
  result->UpdateVTKObjects();
  return result;
}

/// The cells of the input that a selection of the pruned or the removed cells means.
vtkSmartPointer<vtkSMProxy> translated(pqOutputPort* port)
{
  const vtkSmartPointer<vtkSelection> cells = evaluated(port, "InputCell");
  for (unsigned int i = 0; i < cells->GetNumberOfNodes(); ++i)
  {
    cells->GetNode(i)->SetContentType(vtkSelectionNode::INDICES);
  }
  Proxy ids, result;
  ids.TakeReference(
    vtkSMSourceProxy::SafeDownCast(vtkSMSelectionHelper::NewSelectionSourceFromSelection(
      port->getSourceProxy()->GetSession(), cells)));
  result.TakeReference(vtkSMSourceProxy::SafeDownCast(
    vtkSMSelectionHelper::NewAppendSelectionsFromSelectionSource(ids)));
  return result;
}
}

pqMedialSelection::pqMedialSelection(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqProxyPropertyWidget(property, proxy, parent)
  , Copied(this->findChild<pqSelectionInputWidget*>())
{
  auto* button = this->findChild<QPushButton*>("pushButtonCopySelection");
  if (this->Copied && button)
  {
    button->disconnect(this->Copied);
    this->connect(button, &QPushButton::clicked, this, [this] { this->copyActiveSelection(); });
  }
}

bool pqMedialSelection::isInput(pqOutputPort* port) const
{
  const vtkSMPropertyHelper input(this->proxy(), "Input");
  return input.GetNumberOfElements() == 1 && input.GetAsProxy(0) == port->getSourceProxy() &&
    static_cast<int>(input.GetOutputPort(0)) == port->getPortNumber();
}

bool pqMedialSelection::isOwnAxis(pqOutputPort* port) const
{
  return port->getSourceProxy() == this->proxy() && port->getPortNumber() != 1;
}

void pqMedialSelection::copyActiveSelection()
{
  auto* manager =
    qobject_cast<pqSelectionManager*>(pqApplicationCore::instance()->manager("SELECTION_MANAGER"));
  QList<pqOutputPort*> usable;
  QStringList names;
  for (pqOutputPort* port : manager ? manager->getSelectedPorts() : QSet<pqOutputPort*>())
  {
    if (!port->getSelectionInput())
    {
      continue;
    }
    names += port->prettyName();
    if (this->isInput(port) || this->isOwnAxis(port))
    {
      usable += port;
    }
  }
  if (names.empty())
  {
    this->Copied->setSelection(nullptr);
  }
  else if (usable.size() == 1)
  {
    this->Copied->setSelection(this->ofInput(usable.front()));
  }
  else
  {
    this->refuse(names.join(", "));
  }
}

vtkSmartPointer<vtkSMProxy> pqMedialSelection::ofInput(pqOutputPort* port) const
{
  // Points have the same ids everywhere.
  return this->isInput(port) || !isOfCells(evaluated(port, nullptr)) ? copied(port)
                                                                     : translated(port);
}

void pqMedialSelection::refuse(const QString& selected)
{
  QMessageBox refusal(QMessageBox::Warning, "Medial Prune",
    QString(
      "Something is selected on: %1. This filter takes cells or points of its input, or of its "
      "own axis; other cells have other numbers. Select on one of these, and only there.")
      .arg(selected),
    QMessageBox::Ok, this->window());
  refusal.setObjectName("SelectedElsewhere");
  refusal.exec();
}
