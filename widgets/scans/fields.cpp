#include "widgets/scans/fields.h"

#include <QEvent>
#include <QFormLayout>
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
    label->setBuddy(field);
    if (!hint.isEmpty()) {
        label->setToolTip(hint);
        field->setToolTip(hint);
    }
    form.addRow(label, field);
}

void keepFromWheel(QWidget& field) {
    field.setFocusPolicy(Qt::StrongFocus);
    field.installEventFilter(new WheelGuard(&field));
}

}  // namespace leitstand
