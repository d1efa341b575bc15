#include "widgets/mission/record_light.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

constexpr int TextSize = 12, LeastText = 10;              ///< of fonts [px]
constexpr int Dot = 9, Gap = 5, Margin = 6, Height = 16;  ///< [px]

}  // namespace

RecordLight::RecordLight(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    setAccessibleName(tr("Recording"));
}

void RecordLight::show(const RecordText& text) {
    if (text == m_text) return;
    m_text = text;
    setToolTip(text.details);
    setAccessibleDescription(text.value + QStringLiteral("\n") + text.details);
    update();
}

QSize RecordLight::sizeHint() const {
    const QFontMetricsF metrics(sized(font(), LeastText));
    double widest = 0.0;
    for (const QString& value : recordValues()) widest = std::max(widest, metrics.horizontalAdvance(value));
    return {Margin + Dot + Gap + 1 + static_cast<int>(std::ceil(widest)), Height};
}

void RecordLight::paintEvent(QPaintEvent* /*event*/) {
    const ThemeColours& colours = coloursOf(presentTheme());
    const QColor& ink = toneColour(m_text.tone, colours);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawEllipse(QRectF(Margin, (height() - Dot) / 2.0, Dot, Dot));
    painter.setPen(ink);
    const QRect room = rect().adjusted(Margin + Dot + Gap, 0, 0, 0);
    painter.setFont(fitted(font(), m_text.value, room.width(), TextSize, LeastText, false));
    painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, m_text.value);
}

}  // namespace leitstand
