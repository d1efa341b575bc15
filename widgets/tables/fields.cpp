#include "widgets/tables/fields.h"

#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>

namespace leitstand {
namespace {

class WheelGuard final : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

}  // namespace

void addField(QFormLayout& form, const QString& caption, QWidget* field, const QString& hint) {
    auto* label = new QLabel(caption, form.parentWidget());
    label->setProperty("muted", true);
    label->setBuddy(field->focusProxy() == nullptr ? field : field->focusProxy());
    if (!hint.isEmpty()) {
        label->setToolTip(hint);
        field->setToolTip(hint);
        if (QWidget* const inner = field->focusProxy()) inner->setToolTip(hint);
    }
    form.addRow(label, field);
}

QWidget* withUnit(QWidget* field, const QString& unit) {
    auto* both = new QWidget(field->parentWidget());
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(field, 1);
    row->addWidget(new QLabel(unit, both));
    both->setFocusProxy(field);
    return both;
}

void keepFromWheel(QWidget& field) {
    field.setFocusPolicy(Qt::StrongFocus);
    field.installEventFilter(new WheelGuard(&field));
}

}  // namespace leitstand
