#pragma once

#include <QComboBox>
#include <QVariant>

#include "widgets/models/registration_choices.h"

class QAbstractSpinBox;
class QLabel;
class QFormLayout;

namespace leitstand {

/// A combo box that offers @p choices, each with its hint.
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

/// The value chosen in a choiceBox of T.
template <class T>
[[nodiscard]] T chosen(const QComboBox& box) {
    return static_cast<T>(box.currentData().toInt());
}

/// Chooses @p value, where it is on offer.
template <class T>
void choose(QComboBox& box, T value) {
    if (const int index = box.findData(static_cast<int>(value)); index >= 0) box.setCurrentIndex(index);
}

/// Adds a line with a caption, whose mnemonic leads to @p field, and @p hint as its tool tip (none: the
/// field's own).
void addField(QFormLayout& form, const QString& caption, QWidget* field, const QString& hint = {});

/// @p field with @p unit behind it, which a caption may have no room for.
[[nodiscard]] QWidget* withUnit(QWidget* field, const QString& unit);

/// Lets the wheel scroll the panel rather than change @p field, unless the field has the focus.
void keepFromWheel(QWidget& field);

}  // namespace leitstand
