#include "widgets/drive/energy_cell.h"

#include <cmath>

#include "widgets/drive/gauge.h"

namespace leitstand {
namespace {

constexpr int LeastLinkSize = 11;  ///< of its text [px]
const QString Between = QStringLiteral(" · ");

}  // namespace

EnergyCell::EnergyCell(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Battery and link"));
}

void EnergyCell::show(const DriveState& state) {
    m_battery = state.battery;
    m_link = state.link;
    m_reason = state.linkReason;
    m_linkTone = state.linkTone;
    const QString text = tr("Battery %1 %2, %3\nLink: %4 %5")
                             .arg(m_battery.charge.value, m_battery.charge.unit, m_battery.left,
                                  m_link.join(Between), m_reason);
    setAccessibleDescription(text);
    setToolTip(text);
    update();
}

void EnergyCell::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColours& colours = coloursOf(presentTheme());
    painter.fillRect(rect(), colours.strip);
    const double left = 12.0, inner = width() - 22.0;
    const bool tall = height() >= 170;
    double y = 8.0;
    const QColor& leftInk = toneColour(m_battery.leftTone, colours);
    if (tall || m_battery.leftBrief.isEmpty()) {
        paintCaption(painter, {left, y, inner, 18}, tr("Battery"), colours.muted);
    } else {
        // The time left goes beside the caption, or replaces it.
        const QFontMetricsF metrics(sized(painter.font(), CaptionSize));
        const double wide = metrics.horizontalAdvance(m_battery.leftBrief);
        const bool both = metrics.horizontalAdvance(tr("Battery")) + 8.0 + wide <= inner;
        if (both) paintCaption(painter, {left, y, inner, 18}, tr("Battery"), colours.muted);
        const double from = both ? left + inner - wide - 1.0 : left;
        paintCaption(painter, {from, y, left + inner - from, 18}, m_battery.leftBrief, leftInk);
    }
    y += 20.0;
    paintFigure(painter, {left, y, inner, 32}, m_battery.charge, NumberSize, colours);
    y += 33.0;
    if (tall) {
        const QFontMetricsF metrics(sized(painter.font(), CaptionSize));
        const bool fits = metrics.horizontalAdvance(m_battery.left) <= inner;
        paintCaption(painter, {left, y, inner, 18}, fits ? m_battery.left : m_battery.leftBrief, leftInk);
        y += 21.0;
    }
    if (std::isfinite(m_battery.fraction)) {
        painter.fillRect(QRectF(left, y, inner, 5.0), colours.line);
        const Tone tone = m_battery.charge.tone;
        const QColor fill = tone == Tone::Normal ? colours.fine : toneColour(tone, colours);
        painter.fillRect(QRectF(left, y, m_battery.fraction * inner, 5.0), fill);
    }
    y += 13.0;
    paintCaption(painter, {left, y, inner, 18}, tr("Link"), colours.muted);
    y += 19.0;
    // What has no room beside the round trip goes below it, before the reason.
    const QString all = m_link.join(Between);
    const bool bold = m_linkTone == Tone::Attention;
    const double whole = QFontMetricsF(sized(painter.font(), LeastLinkSize, bold)).horizontalAdvance(all);
    const QString first = whole <= inner || m_link.isEmpty() ? all : m_link.first();
    QStringList below = whole <= inner ? QStringList() : m_link.mid(1);
    if (!m_reason.isEmpty()) below += m_reason;
    painter.setFont(fitted(painter.font(), first, inner, 14, LeastLinkSize, bold));
    painter.setPen(toneColour(m_linkTone, colours));
    painter.drawText(QRectF(left, y, inner, 20), Qt::AlignLeft | Qt::AlignVCenter, first);
    y += 21.0;
    painter.setFont(sized(painter.font(), CaptionSize));
    const int lines = static_cast<int>((height() - 4.0 - y) / QFontMetricsF(painter.font()).height());
    if (lines > 0) paintWrapped(painter, {left, y, inner, height() - y}, below.join(Between), lines);
}

}  // namespace leitstand
