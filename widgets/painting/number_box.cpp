#include "widgets/painting/number_box.h"

#include <QKeyEvent>

#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

const QChar Minus(0x2212);

}  // namespace

NumberBox::NumberBox(double low, double high, double step, int decimals, const QString& unit, QWidget* parent)
    : QDoubleSpinBox(parent) {
    setDecimals(decimals);
    setRange(low, high);
    setSingleStep(step);
    if (!unit.isEmpty()) setSuffix(QLatin1Char(' ') + unit);
    setKeyboardTracking(false);
}

double NumberBox::valueFromText(const QString& text) const {
    return QDoubleSpinBox::valueFromText(QString(text).replace(Minus, locale().negativeSign()));
}

QString NumberBox::textFromValue(double value) const {
    return numberText(value, decimals());
}

QValidator::State NumberBox::validate(QString& input, int& position) const {
    QString plain = QString(input).replace(Minus, locale().negativeSign());
    return QDoubleSpinBox::validate(plain, position);
}

bool NumberBox::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const QString text = static_cast<QKeyEvent*>(event)->text();
        if (!text.isEmpty() && text.front().isLetter()) {
            event->ignore();
            return false;
        }
    }
    return QDoubleSpinBox::event(event);
}

}  // namespace leitstand
