// SPDX-License-Identifier: BSD-3-Clause
#include "pqMedialSchedule.h"

#include "pqScalarValueListPropertyWidget.h"
#include "vtkMedialPrune.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLineEdit>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QTimer>
#include <QValidator>

#include <string>
#include <vector>

namespace
{
/// What a measure is, and its unit.
QString tipOf(int measure)
{
  return QString("%1 (%2)").arg(
    vtkMedialPrune::GetMeasureDescription(measure), vtkMedialPrune::GetMeasureUnit(measure));
}

/// The rows of a preset in the table: measure, threshold, passes one after another. A word, such as h0.5s,
/// begins with the letter of its measure.
QVariantList rowsOf(const QString& words)
{
  QVariantList result;
  for (const QString& word : words.split(' '))
  {
    for (int i = 0; vtkMedialPrune::GetMeasureName(i); ++i)
    {
      const std::string pattern = vtkMedialPrune::GetMeasureWord(i);
      if (word[0] == QChar(pattern[0]))
      {
        const bool isShare = pattern.back() == '%'; // in the table 0 ... 1
        const QString threshold =
          isShare ? QString::number(word.mid(1).chopped(1).toDouble() / 100) : word.mid(1);
        result << vtkMedialPrune::GetMeasureName(i) << threshold << "0";
      }
    }
  }
  return result;
}

/// A drop-down of all presets, with what they remove as tips.
QComboBox* presets(QWidget* parent)
{
  auto* result = new QComboBox(parent);
  result->setObjectName("Preset");
  result->addItem("Take the rows of a preset ...");
  for (int i = 0; vtkMedialPrune::GetPresetName(i); ++i)
  {
    result->addItem(vtkMedialPrune::GetPresetName(i));
    result->setItemData(i + 1, vtkMedialPrune::GetPresetDescription(i), Qt::ToolTipRole);
  }
  return result;
}

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
      measures->setItemData(i, tipOf(i), Qt::ToolTipRole);
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

/// Takes what the filter takes beside a measure, and turns a decimal comma into a point as it is typed.
class NumberValidator : public QValidator
{
public:
  NumberValidator(const QString& measure, bool isOfPasses, QObject* parent)
    : QValidator(parent)
    , Measure(measure.toStdString())
    , IsOfPasses(isOfPasses)
  {
  }

  std::string fault(const QString& text) const
  {
    const std::string number = text.toStdString();
    return vtkMedialPrune::GetIterationFault(this->Measure.c_str(),
      this->IsOfPasses ? "0" : number.c_str(), this->IsOfPasses ? number.c_str() : "0");
  }

  State validate(QString& text, int&) const override
  {
    text.replace(',', '.');
    return this->fault(text).empty() ? Acceptable : Intermediate;
  }

private:
  std::string Measure;
  bool IsOfPasses;
};

/// Edits a threshold or a number of passes. While the text can't be taken it is red, its tip says why,
/// and leaving the cell brings the old number back.
class NumberDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(
    QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override
  {
    auto* editor = new QLineEdit(parent);
    const QString measure = index.sibling(index.row(), 0).data().toString();
    auto* validator = new NumberValidator(measure, index.column() == 2, editor);
    editor->setValidator(validator);
    QObject::connect(editor, &QLineEdit::textChanged, editor, [editor, validator] {
      const std::string fault = validator->fault(editor->text());
      editor->setStyleSheet(fault.empty() ? "" : "color: red");
      editor->setToolTip(QString::fromStdString(fault));
    });
    return editor;
  }
};

/// Names the columns. ParaView 5.13 takes other strings than the versions before.
template <typename Labels>
void name(pqScalarValueListPropertyWidget* list,
  void (pqScalarValueListPropertyWidget::*setLabels)(Labels&))
{
  std::remove_const_t<Labels> labels = { "Measure", "Threshold", "Passes" };
  (list->*setLabels)(labels);
}
}

pqMedialSchedule::pqMedialSchedule(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqStringVectorPropertyWidget(property, proxy, parent)
{
  if (auto* list = this->findChild<pqScalarValueListPropertyWidget*>())
  {
    name(list, &pqScalarValueListPropertyWidget::setLabels);
    list->setShowLabels(true);
    if (auto* box = qobject_cast<QBoxLayout*>(this->layout()))
    {
      QComboBox* choice = presets(this);
      box->insertWidget(0, choice);
      this->connect(choice, QOverload<int>::of(&QComboBox::activated), list, [list](int item) {
        if (item > 0)
        {
          list->setScalars(rowsOf(vtkMedialPrune::GetPresetWords(item - 1)));
          Q_EMIT list->scalarsChanged();
        }
      });
    }
  }
  if (auto* table = this->findChild<QTableView*>())
  {
    table->setItemDelegateForColumn(0, new MeasureDelegate(table));
    table->setItemDelegateForColumn(1, new NumberDelegate(table));
    table->setItemDelegateForColumn(2, new NumberDelegate(table));
  }
}
