#include "widgets/robots/robot_chip_button.h"

#include <algorithm>
#include <cmath>

#include "widgets/models/live/robots/robot_row.h"
#include "widgets/painting/pane_paint.h"
#include "widgets/robots/release_handle.h"
#include "widgets/robots/robot_bar_sizes.h"
#include "widgets/robots/robot_signs.h"

namespace leitstand {
namespace {

using robot_bar::Side, robot_bar::Sign, robot_bar::TextSize, robot_bar::Upper;
constexpr int Edge = 3;                          ///< of the robot's colour, on the left [px]
constexpr double LinkLeft = 7.0, Between = 4.0;  ///< before the sign of the link, between parts [px]
constexpr int LetterSize = 14, LeastText = 10;   ///< of fonts [px]

/// Paints the first of @p texts that fits into @p room. Prefers a shorter text over a smaller font.
void paintWhatFits(QPainter& painter, const QRectF& room, const QStringList& texts) {
    for (int size = TextSize; size >= LeastText; --size) {
        painter.setFont(sized(painter.font(), size));
        const QFontMetricsF metrics(painter.font());
        for (const QString& text : texts) {
            if (metrics.horizontalAdvance(text) > room.width()) continue;
            painter.drawText(room.adjusted(0, 0, 1, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
            return;
        }
    }
}

}  // namespace

RobotChipButton::RobotChipButton(const QString& key, QWidget* parent)
    : QAbstractButton(parent), m_key(key), m_handle(new ReleaseHandle(this)) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    m_handle->hide();
    connect(m_handle, &ReleaseHandle::held, this, &RobotChipButton::releaseRequested);
}

void RobotChipButton::show(const RobotChip& chip, const StopLine& stop) {
    if (m_chip == chip && m_stop == stop) return;
    m_chip = chip;
    m_stop = stop;
    m_handle->show(stop);
    const QString details = robotDetails(chip, stop);
    setToolTip(m_key.isEmpty() ? details : details + QLatin1Char('\n') + tr("%1 selects").arg(m_key));
    setAccessibleName(tr("Robot %1").arg(chip.face.title));
    setAccessibleDescription(details);
    update();
}

int RobotChipButton::foldedWidth(const QFont& font) {
    const QFont letter = sized(font, LetterSize, true), text = sized(font, TextSize);
    const double figures = LinkLeft + Sign + 2.0 * Between + QFontMetricsF(letter).horizontalAdvance(u'H') +
                           QFontMetricsF(text).horizontalAdvance(QStringLiteral("88\u202f%")) + Side;
    return std::max(static_cast<int>(std::ceil(figures)), Edge + ReleaseHandle::foldedWidth(font) + 1);
}

void RobotChipButton::resizeEvent(QResizeEvent* /*event*/) {
    m_handle->setGeometry(Edge, Upper - 1, width() - Edge - 1, height() - Upper);
}

void RobotChipButton::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& colours = coloursOf(presentTheme());
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isChecked() ? colours.chosen : underMouse() ? colours.hover : colours.window);
    painter.drawRoundedRect(box, 4, 4);
    if (m_stop.stage == StopStage::None)
        paintMode(painter, QRectF(Edge, Upper, width() - Edge - 1, height() - Upper - 1));
    painter.fillRect(QRect(0, 2, Edge, height() - 4), colours.robot(m_chip.face.place));
    paintIdentity(painter, QRectF(0, 1, width(), Upper - 1));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(isChecked() || hasFocus() ? colours.select : colours.line, isChecked() ? 2.0 : 1.0));
    painter.drawRoundedRect(box, 4, 4);
}

void RobotChipButton::paintIdentity(QPainter& painter, const QRectF& line) const {
    const ThemeColours& colours = coloursOf(presentTheme());
    double x = LinkLeft;
    paintLinkSign(painter, QRectF(x, line.center().y() - 0.5 * Sign, Sign, Sign), m_chip.link, colours);
    x += Sign + Between;
    painter.setFont(sized(font(), LetterSize, true));
    painter.setPen(colours.text);
    const double letter = QFontMetricsF(painter.font()).horizontalAdvance(m_chip.face.letter);
    painter.drawText(QRectF(x, line.top(), letter + 2, line.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     m_chip.face.letter);
    x += letter + Between;
    QStringList all;
    if (!m_chip.figures.isEmpty()) all += m_chip.face.title + QChar(0x2002) + m_chip.figures.first();
    all += m_chip.figures;
    if (m_chip.figures.isEmpty()) all += m_chip.face.title;
    painter.setPen(toneColour(m_chip.tone, colours));
    paintWhatFits(painter, line.adjusted(x, 0, -Side, 0), all);
}

void RobotChipButton::paintMode(QPainter& painter, const QRectF& line) const {
    const ThemeColours& colours = coloursOf(presentTheme());
    paintModeSurface(painter, line, m_chip.mode, colours, 3.0);
    painter.setFont(font());
    painter.setPen(modeInk(m_chip.mode, colours));
    paintWhatFits(painter, line.adjusted(LinkLeft - Edge, 0, -Side, 0), m_chip.modes);
}

}  // namespace leitstand
