#include "widgets/mission/record_light.h"

#include <QPainter>

#include "widgets/pane_paint.h"

namespace leitstand {
namespace {

constexpr int TextSize = 12, Dot = 9, Gap = 5, Height = 32;  ///< [px]

}  // namespace

RecordLight::RecordLight(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Recording"));
}

void RecordLight::show(const RecordText& text) {
    if (text == m_text) return;
    const bool grows = text.value != m_text.value;
    m_text = text;
    setToolTip(text.details);
    setAccessibleDescription(text.value + QStringLiteral("\n") + text.details);
    if (grows) updateGeometry();
    update();
}

QSize RecordLight::sizeHint() const {
    return {Dot + Gap + QFontMetrics(sized(font(), TextSize)).horizontalAdvance(m_text.value), Height};
}

void RecordLight::paintEvent(QPaintEvent* /*event*/) {
    const ThemeColours& colours = coloursOf(presentTheme());
    const QColor& ink = toneColour(m_text.tone, colours);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawEllipse(QRectF(0.0, (height() - Dot) / 2.0, Dot, Dot));
    painter.setPen(ink);
    painter.setFont(sized(font(), TextSize));
    painter.drawText(rect().adjusted(Dot + Gap, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, m_text.value);
}

}  // namespace leitstand
