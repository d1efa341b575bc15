#include "widgets/painting/pane_paint.h"

#include <algorithm>

#include <QFontMetricsF>
#include <QTextLayout>

namespace leitstand {
namespace {

constexpr int Edge = 3;     ///< width of the line in the robot's colour [px]
constexpr int Margin = 10;  ///< beside text [px]

}  // namespace

int paneHeadHeight(const QFont& font) {
    return static_cast<int>(QFontMetricsF(font).height()) + 12;
}

void paintPaneHead(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours) {
    painter.save();
    const int height = paneHeadHeight(painter.font());
    QColor veil = colours.window;
    veil.setAlpha(225);
    painter.fillRect(QRect(pane.left(), pane.top(), pane.width(), height), veil);
    painter.fillRect(QRect(pane.left(), pane.top(), Edge, pane.height()), colours.robot(head.face.place));

    const Freshness freshness = freshnessOf(head.age, head.limits);
    const QString note = head.note.isEmpty() ? QString() : QStringLiteral(" · ") + head.note;
    QString right = (head.vacant ? QString() : ageText(head.age, head.limits)) + note;
    const QRect line(pane.left() + Margin, pane.top(), pane.width() - 2 * Margin, height);
    const QFontMetrics metrics(painter.font());
    const QString title =
        head.face.letter.isEmpty() ? head.title : head.face.letter + QStringLiteral(" · ") + head.title;
    const auto room = [&] { return line.width() - metrics.horizontalAdvance(right) - Margin; };
    // paintLoss() also reports in the middle that nothing has arrived yet.
    if (!head.vacant && freshness == Freshness::Never && metrics.horizontalAdvance(title) > room())
        right = QStringLiteral("–") + note;
    painter.setPen(toneColour(toneOf(freshness), colours));
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, right);
    painter.setPen(colours.text);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(title, Qt::ElideRight, room()));
    painter.restore();
}

void paintLoss(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours) {
    const QString text = head.vacant ? QString() : lossText(head.age, head.limits);
    if (text.isEmpty()) return;
    painter.save();
    const bool never = freshnessOf(head.age, head.limits) == Freshness::Never;
    painter.setFont(fitted(painter.font(), text, pane.width() - 5.0 * Margin, 22, 12, !never));
    const QFontMetricsF metrics(painter.font());
    QRectF box(0, 0, metrics.horizontalAdvance(text) + 2.0 * Margin, metrics.height() + Margin);
    box.moveCenter(QRectF(pane).center());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.strip);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(never ? colours.muted : colours.attention);
    painter.drawText(box, Qt::AlignCenter, text);
    painter.restore();
}

const QColor& toneColour(Tone tone, const ThemeColours& colours) {
    switch (tone) {
        case Tone::Normal:
            return colours.text;
        case Tone::Muted:
            return colours.muted;
        case Tone::Attention:
            return colours.attention;
        case Tone::Act:
            return colours.act;
    }
    return colours.text;
}

QColor greyed(const QColor& colour) {
    const int grey = qGray(colour.rgb());
    return {grey, grey, grey, colour.alpha()};
}

void paintModeSurface(QPainter& painter, const QRectF& box, ModeKind mode, const ThemeColours& colours,
                      double radius) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, radius > 0.0);
    painter.setPen(Qt::NoPen);
    switch (mode) {
        case ModeKind::Teleoperation:
            painter.setBrush(colours.teleoperation);
            break;
        case ModeKind::Autonomous:
            painter.setBrush(colours.autonomous);
            break;
        case ModeKind::Stopped:
            painter.setBrush(colours.stopped);
            break;
        case ModeKind::Stop:
            painter.setBrush(colours.stop);
            break;
        case ModeKind::Lost:
            painter.setBrush(colours.lost);
            break;
    }
    painter.drawRoundedRect(box, radius, radius);
    if (mode == ModeKind::Lost) {
        QColor stripe = colours.attention;
        stripe.setAlpha(70);
        painter.setBrush(QBrush(stripe, Qt::BDiagPattern));
        painter.drawRoundedRect(box, radius, radius);
    }
    painter.restore();
}

QColor modeInk(ModeKind mode, const ThemeColours& colours) {
    return mode == ModeKind::Stop ? QColor(Qt::white) : colours.text;
}

QFont sized(QFont font, int pixels, bool bold) {
    font.setPixelSize(pixels);
    font.setBold(bold);
    return font;
}

QFont fitted(const QFont& font, const QString& text, double width, int pixels, int least, bool bold) {
    QFont found = sized(font, pixels, bold);
    while (pixels > least && QFontMetricsF(found).horizontalAdvance(text) > width)
        found = sized(font, --pixels, bold);
    return found;
}

void paintWrapped(QPainter& painter, const QRectF& box, const QString& text, int lines) {
    QTextLayout layout(text, painter.font());
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    const QFontMetricsF metrics(painter.font());
    double y = box.top() + metrics.ascent();
    layout.beginLayout();
    for (int i = 0; i < lines; ++i) {
        QTextLine line = layout.createLine();
        if (!line.isValid()) break;
        line.setLineWidth(box.width());
        const bool last = i + 1 == lines;
        const QString part =
            last ? text.mid(line.textStart()) : text.mid(line.textStart(), line.textLength());
        painter.drawText(QPointF(box.left(), y),
                         metrics.elidedText(part.trimmed(), Qt::ElideRight, box.width()));
        y += metrics.height();
    }
    layout.endLayout();
}

}  // namespace leitstand
