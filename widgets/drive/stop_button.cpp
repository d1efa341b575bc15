#include "widgets/drive/stop_button.h"

#include <cmath>

#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

constexpr int TextSize = 17, KeySize = 12;         ///< of fonts [px]
constexpr int Height = 42, Upper = 25, Side = 12;  ///< of the button; of the upper line; beside the text [px]

}  // namespace

StopButton::StopButton(QWidget* parent) : QAbstractButton(parent) {
    setText(tr("STOP ALL"));
    setObjectName(QStringLiteral("stop"));
    setAccessibleName(tr("Stop all robots"));
    setToolTip(
        tr("Stops all robots and holds them until each is released (Esc, always and everywhere).\n"
           "A function of this program, no certified emergency stop."));
    // A click never takes the focus: driving keeps the keys.
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(this, &QAbstractButton::pressed, this, &StopButton::stopRequested);
}

QSize StopButton::sizeHint() const {
    const double text = QFontMetricsF(sized(font(), TextSize, true)).horizontalAdvance(this->text());
    return {static_cast<int>(std::ceil(text)) + 2 * Side, Height};
}

void StopButton::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& colours = coloursOf(presentTheme());
    const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
    painter.setPen(hasFocus() ? QPen(colours.text, 2.0) : QPen(Qt::NoPen));
    painter.setBrush(isDown()       ? colours.stop.darker(125)
                     : underMouse() ? colours.stop.lighter(112)
                                    : colours.stop);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(Qt::white);
    painter.setFont(sized(font(), TextSize, true));
    painter.drawText(QRect(0, 2, width(), Upper - 2), Qt::AlignCenter, text());
    painter.setFont(sized(font(), KeySize));
    painter.drawText(QRect(0, Upper - 2, width(), height() - Upper), Qt::AlignCenter, tr("Esc"));
}

}  // namespace leitstand
