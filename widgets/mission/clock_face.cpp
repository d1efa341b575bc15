#include "widgets/mission/clock_face.h"

#include <QPainter>

#include "widgets/pane_paint.h"

namespace leitstand {
namespace {

constexpr int CaptionSize = 12, ValueSize = 20, Gap = 6, Margin = 6, Height = 32;  ///< [px]

}  // namespace

ClockFace::ClockFace(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to driving
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Mission clock"));
}

void ClockFace::show(const ClockText& text) {
    if (text == m_text) return;
    const bool grows = text.value.size() != m_text.value.size() || text.caption != m_text.caption;
    m_text = text;
    setToolTip(text.details);
    setAccessibleDescription(text.details);
    if (grows) updateGeometry();
    update();
}

QSize ClockFace::sizeHint() const {
    const QFontMetrics caption(sized(font(), CaptionSize)), value(sized(font(), ValueSize, true));
    return {
        2 * Margin + caption.horizontalAdvance(m_text.caption) + Gap + value.horizontalAdvance(m_text.value),
        Height};
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
    const QFont small = sized(font(), CaptionSize), large = sized(font(), ValueSize, true);
    const QFontMetrics metrics(large);
    // Both stand on one line.
    const int base = (height() + metrics.ascent() - metrics.descent()) / 2;
    const bool calm = m_text.tone == Tone::Normal;
    painter.setFont(small);
    painter.setPen(calm ? colours.muted : toneColour(m_text.tone, colours));
    painter.drawText(inner.left(), base, m_text.caption);
    const int after = inner.left() + QFontMetrics(small).horizontalAdvance(m_text.caption) + Gap;
    painter.setFont(large);
    painter.setPen(calm ? colours.text : toneColour(m_text.tone, colours));
    painter.drawText(after, base, m_text.value);
}

}  // namespace leitstand
