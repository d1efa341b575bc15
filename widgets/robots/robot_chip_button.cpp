#include "widgets/robots/robot_chip_button.h"

#include <algorithm>

#include "widgets/pane_paint.h"

namespace leitstand {
namespace {

constexpr int Mark = 10;              ///< size of the link's mark [px]
constexpr int Air = 12, Between = 8;  ///< at the ends, between parts [px]

/// Circle: connected; square: degraded; cross: lost; ring: not heard yet.
void paintMark(QPainter& painter, const QRectF& box, LinkState link, const ThemeColours& colours) {
    painter.setPen(Qt::NoPen);
    switch (link) {
        case LinkState::Connected:
            painter.setBrush(colours.fine);
            painter.drawEllipse(box);
            break;
        case LinkState::Degraded:
            painter.setBrush(colours.attention);
            painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5));
            break;
        case LinkState::Lost:
            painter.setPen(QPen(colours.act, 2.5, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(box.topLeft(), box.bottomRight());
            painter.drawLine(box.topRight(), box.bottomLeft());
            break;
        case LinkState::NeverSeen:
            painter.setPen(QPen(colours.muted, 1.5));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(box.adjusted(1, 1, -1, -1));
            break;
    }
}

}  // namespace

RobotChipButton::RobotChipButton(const QString& key, QWidget* parent) : QAbstractButton(parent), m_key(key) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
}

void RobotChipButton::show(const RobotChip& chip) {
    if (m_chip == chip) return;
    const bool otherSize = m_chip.texts != chip.texts || m_chip.face != chip.face;
    m_chip = chip;
    setToolTip(m_key.isEmpty() ? chip.details
                               : chip.details + QLatin1Char('\n') + tr("%1 selects").arg(m_key));
    setAccessibleName(tr("Robot %1").arg(chip.face.title));
    setAccessibleDescription(chip.details);
    if (otherSize) updateGeometry();
    update();
}

int RobotChipButton::widthFor(const QString& text) const {
    const int letter = QFontMetrics(sized(font(), 13, true)).horizontalAdvance(m_chip.face.letter);
    return 2 * Air + Mark + 2 * Between + letter + QFontMetrics(sized(font(), 13)).horizontalAdvance(text) +
           2;
}

QSize RobotChipButton::sizeHint() const {
    return {m_chip.texts.isEmpty() ? 80 : widthFor(m_chip.texts.first()), 30};
}

QSize RobotChipButton::minimumSizeHint() const {
    return {m_chip.texts.isEmpty() ? 80 : widthFor(m_chip.texts.last()), 30};
}

void RobotChipButton::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& colours = coloursOf(presentTheme());
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(isChecked() || hasFocus() ? colours.select : colours.line);
    painter.setBrush(isChecked() ? colours.chosen : underMouse() ? colours.hover : colours.window);
    painter.drawRoundedRect(box, 4, 4);
    painter.fillRect(QRectF(box.left() + 4, box.bottom() - 2, box.width() - 8, 2),
                     colours.robot(m_chip.face.place));
    double x = Air;
    paintMark(painter, QRectF(x, 0.5 * (height() - Mark), Mark, Mark), m_chip.link, colours);
    x += Mark + Between;
    painter.setFont(sized(font(), 13, true));
    painter.setPen(colours.text);
    const double letter = QFontMetricsF(painter.font()).horizontalAdvance(m_chip.face.letter);
    painter.drawText(QRectF(x, 0, letter + 2, height()), Qt::AlignLeft | Qt::AlignVCenter,
                     m_chip.face.letter);
    x += letter + Between;
    painter.setFont(sized(font(), 13));
    const auto fits = [this](const QString& text) { return widthFor(text) <= width(); };
    const auto text = std::find_if(m_chip.texts.begin(), m_chip.texts.end(), fits);
    painter.setPen(toneColour(m_chip.tone, colours));
    const QRectF room(x, 0, width() - x - 4, height());
    const QString shown = text != m_chip.texts.end() ? *text
                          : m_chip.texts.isEmpty()   ? QString()
                                                     : m_chip.texts.last();
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, shown);
}

}  // namespace leitstand
