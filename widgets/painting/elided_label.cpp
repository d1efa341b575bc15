#include "widgets/painting/elided_label.h"

#include <algorithm>

#include <QPainter>
#include <QStyle>

#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

constexpr int SmallSize = 11;  ///< of text in several lines [px]

}  // namespace

QSize ElidedLabel::minimumSizeHint() const {
    return {0, QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const QRect area = contentsRect();
    const QFont small = sized(font(), SmallSize);
    const int lines = static_cast<int>((area.height() + 1.0) / QFontMetricsF(small).height());
    if (m_mostLines > 1 && lines > 1 && fontMetrics().horizontalAdvance(text()) > area.width()) {
        const int shown = std::min(lines, m_mostLines);
        painter.setFont(small);
        painter.setPen(palette().color(foregroundRole()));
        const double high = shown * QFontMetricsF(small).height();
        paintWrapped(painter, QRectF(area.left(), area.center().y() + 0.5 - high / 2, area.width(), high),
                     text(), shown);
        return;
    }
    style()->drawItemText(&painter, area, static_cast<int>(alignment()), palette(), isEnabled(),
                          fontMetrics().elidedText(text(), Qt::ElideRight, area.width()), foregroundRole());
}

}  // namespace leitstand
