#pragma once

#include <QComboBox>
#include <QVariant>

#include "widgets/models/registration_choices.h"

class QAbstractSpinBox;
class QLabel;
class QFormLayout;

namespace leitstand {

/// Returns a combo box that offers @p choices, each with its hint.
template <class T>
QComboBox* choiceBox(const std::vector<Choice<T>>& choices, QWidget* parent) {
    auto* box = new QComboBox(parent);
    for (const Choice<T>& choice : choices) {
        box->addItem(choice.name, static_cast<int>(choice.value));
        box->setItemData(box->count() - 1, choice.hint, Qt::ToolTipRole);
    }
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(10);
    QObject::connect(box, &QComboBox::currentIndexChanged, box,
                     [box] { box->setToolTip(box->currentData(Qt::ToolTipRole).toString()); });
    box->setToolTip(box->currentData(Qt::ToolTipRole).toString());
    return box;
}

/// Returns the value selected in a choiceBox of T.
template <class T>
[[nodiscard]] T chosen(const QComboBox& box) {
    return static_cast<T>(box.currentData().toInt());
}

/// Selects @p value, if it is offered.
template <class T>
void choose(QComboBox& box, T value) {
    if (const int index = box.findData(static_cast<int>(value)); index >= 0) box.setCurrentIndex(index);
}

/// Adds @p field as a line of @p form. The mnemonic of @p caption focuses the field. @p hint: tooltip of
/// caption and field; empty: the field keeps its own.
void addField(QFormLayout& form, const QString& caption, QWidget* field, const QString& hint = {});

/// Returns a widget that shows @p field and, to its right, @p unit.
[[nodiscard]] QWidget* withUnit(QWidget* field, const QString& unit);

/// Makes the wheel scroll the panel instead of changing @p field, unless the field has the focus.
void keepFromWheel(QWidget& field);

}  // namespace leitstand
