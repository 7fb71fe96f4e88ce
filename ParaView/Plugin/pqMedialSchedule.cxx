// SPDX-License-Identifier: BSD-3-Clause
#include "pqMedialSchedule.h"

#include "pqScalarValueListPropertyWidget.h"
#include "vtkMedialPrune.h"

#include <QComboBox>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QTimer>

#include <vector>

namespace
{
/// Edits a cell with a drop-down of all measures, open at once, and done with the choice.
class MeasureDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(
    QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override
  {
    auto* measures = new QComboBox(parent);
    for (int i = 0; vtkMedialPrune::GetMeasureName(i); ++i)
    {
      measures->addItem(vtkMedialPrune::GetMeasureName(i));
    }
    auto* self = const_cast<MeasureDelegate*>(this); // Qt's signals aren't const
    QObject::connect(measures, QOverload<int>::of(&QComboBox::activated), self, [self, measures] {
      Q_EMIT self->commitData(measures);
      Q_EMIT self->closeEditor(measures);
    });
    QTimer::singleShot(0, measures, [measures] { measures->showPopup(); });
    return measures;
  }
};
}

pqMedialSchedule::pqMedialSchedule(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqStringVectorPropertyWidget(property, proxy, parent)
{
  if (auto* list = this->findChild<pqScalarValueListPropertyWidget*>())
  {
    std::vector<const char*> labels = { "Measure", "Threshold", "Passes" };
    list->setLabels(labels);
    list->setShowLabels(true);
  }
  if (auto* table = this->findChild<QTableView*>())
  {
    table->setItemDelegateForColumn(0, new MeasureDelegate(table));
  }
}
