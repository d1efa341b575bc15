#include "widgets/mission/clock_face.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

constexpr int CaptionSize = 12, ValueSize = 20, LeastValue = 14;  ///< of fonts [px]
constexpr int Gap = 6, Margin = 6, Height = 26;                   ///< [px]

}  // namespace

ClockFace::ClockFace(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::TabFocus);  // a click never takes the focus: driving keeps the keys
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    setAccessibleName(tr("Mission clock"));
}

void ClockFace::show(const ClockText& text) {
    if (text == m_text) return;
    m_text = text;
    setToolTip(text.details);
    setAccessibleDescription(text.details);
    update();
}

QSize ClockFace::sizeHint() const {
    const QFontMetricsF caption(sized(font(), CaptionSize)), value(sized(font(), ValueSize, true));
    double widest = 0.0;
    for (const QString& one : clockCaptions()) widest = std::max(widest, caption.horizontalAdvance(one));
    const double all = widest + Gap + value.horizontalAdvance(QStringLiteral("88:88"));
    return {2 * Margin + static_cast<int>(std::ceil(all)), Height};
}

void ClockFace::paintEvent(QPaintEvent* /*event*/) {
    const ThemeColours& colours = coloursOf(presentTheme());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || hasFocus()) {
        painter.setPen(hasFocus() ? QPen(colours.select) : Qt::NoPen);
        painter.setBrush(colours.hover);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
    const QRect inner = rect().adjusted(Margin, 0, -Margin, 0);
    const QFont small = sized(font(), CaptionSize);
    const int caption = QFontMetrics(small).horizontalAdvance(m_text.caption);
    // Times of an hour and more get a smaller font.
    const QFont large = fitted(font(), m_text.value, inner.width() - caption - Gap, ValueSize, LeastValue);
    const QFontMetrics metrics(large);
    // Both texts share a baseline.
    const int base = (height() + metrics.ascent() - metrics.descent()) / 2;
    const bool calm = m_text.tone == Tone::Normal;
    painter.setFont(small);
    painter.setPen(calm ? colours.muted : toneColour(m_text.tone, colours));
    painter.drawText(inner.left(), base, m_text.caption);
    const int after = inner.left() + caption + Gap;
    painter.setFont(large);
    painter.setPen(calm ? colours.text : toneColour(m_text.tone, colours));
    painter.drawText(after, base, m_text.value);
}

}  // namespace leitstand
