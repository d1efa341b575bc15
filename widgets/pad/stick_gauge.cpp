#include "widgets/pad/stick_gauge.h"

#include <QPainter>

#include "widgets/models/pad/pad_texts.h"
#include "widgets/painting/theme.h"

namespace leitstand {

StickGauge::StickGauge(PadAction plus, QWidget* parent) : QWidget(parent), m_plus(plus) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Tick: the stick as it is held; shade: dead zone; bar: what comes of it"));
    setAccessibleName(tr("%1 and opposite").arg(padActionName(plus)));
}

void StickGauge::show(const PadBindings& bindings, const PadState& state) {
    m_raw = deflectionOf(bindings, m_plus, state);
    m_shaped = shapedOf(bindings, m_plus, state);
    m_zone = bindings.deadZone;
    setAccessibleDescription(tr("%1 %").arg(qRound(100 * m_shaped)));
    update();
}

void StickGauge::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColours& colours = coloursOf(presentTheme());
    const double half = width() / 2.0 - 2.0, middle = width() / 2.0, line = height() / 2.0;
    painter.fillRect(QRectF(middle - half, line - 3, 2 * half, 6), colours.field);
    painter.fillRect(QRectF(middle - m_zone * half, line - 6, 2 * m_zone * half, 12), colours.line);
    // Plus is left of the middle, as the hand moves.
    painter.fillRect(QRectF(middle, line - 3, -m_shaped * half, 6).normalized(), colours.select);
    painter.fillRect(QRectF(middle - m_raw * half - 1, line - 8, 2, 16), colours.text);
}

}  // namespace leitstand
