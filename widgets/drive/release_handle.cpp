#include "widgets/drive/release_handle.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimerEvent>

#include "widgets/pane_paint.h"

namespace leitstand {
namespace {

constexpr int Tick = 30;    ///< [ms]
constexpr int Height = 20;  ///< [px]

bool holdsBy(const QKeyEvent& event) {
    return event.key() == Qt::Key_Space || event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

}  // namespace

ReleaseHandle::ReleaseHandle(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ReleaseHandle::show(const StopLine& line) {
    if (m_line == line) return;
    const bool wider = m_line.text != line.text;
    m_line = line;
    setFocusPolicy(line.releasable ? Qt::TabFocus : Qt::NoFocus);
    setCursor(line.releasable ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (!line.releasable) end();
    const QString hint =
        line.releasable ? tr("Hold for one second to let %1 move again.").arg(line.face.title) : QString();
    setToolTip(line.details.isEmpty() ? hint : line.details + QLatin1Char('\n') + hint);
    setAccessibleName(tr("Release %1").arg(line.face.title));
    setAccessibleDescription(line.text + QLatin1Char(' ') + line.details);
    setVisible(line.stage != StopStage::None);
    if (wider) updateGeometry();
    update();
}

QString ReleaseHandle::text() const {
    return m_line.releasable ? tr("%1 · hold to release").arg(m_line.text) : m_line.text;
}

QString ReleaseHandle::essential() const {
    return m_line.text.section(QStringLiteral(" · "), -1);
}

QSize ReleaseHandle::sizeHint() const {
    const QFontMetrics metrics(sized(font(), 12, true));
    return {metrics.horizontalAdvance(m_line.face.letter + text()) + 34, Height};
}

QSize ReleaseHandle::minimumSizeHint() const {
    const QFontMetrics metrics(sized(font(), 12, true));
    return {
        metrics.horizontalAdvance(m_line.face.letter + m_line.text.section(QStringLiteral(" · "), 0, 0)) + 34,
        Height};
}

void ReleaseHandle::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColours& colours = coloursOf(presentTheme());
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_line.releasable ? colours.field : colours.strip);
    painter.drawRoundedRect(box, 4, 4);
    if (const double share = m_hold.progress(SteadyTime::clock::now()); share > 0.0) {
        painter.setBrush(colours.chosen);
        painter.drawRoundedRect(QRectF(box.left(), box.top(), share * box.width(), box.height()), 4, 4);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(hasFocus() ? colours.select : m_line.releasable ? colours.muted : colours.line);
    painter.drawRoundedRect(box, 4, 4);
    painter.setFont(sized(font(), 12, true));
    const int letter = painter.fontMetrics().horizontalAdvance(m_line.face.letter);
    painter.setPen(colours.text);
    painter.drawText(rect().adjusted(8, 0, -8, 0), Qt::AlignLeft | Qt::AlignVCenter, m_line.face.letter);
    painter.setFont(sized(font(), 12));
    painter.setPen(toneColour(m_line.tone, colours));
    const QRect room = rect().adjusted(16 + letter, 0, -8, 0);
    const QFontMetrics metrics = painter.fontMetrics();
    QString shown = metrics.elidedText(essential(), Qt::ElideMiddle, room.width());
    for (const QString& one : {m_line.text, text()}) {
        if (metrics.horizontalAdvance(one) <= room.width()) shown = one;
    }
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, shown);
}

void ReleaseHandle::begin() {
    if (!m_line.releasable || m_hold.isHeld()) return;
    m_hold.begin(SteadyTime::clock::now());
    m_timer.start(Tick, this);
    update();
}

void ReleaseHandle::end() {
    m_hold.end();
    m_timer.stop();
    update();
}

void ReleaseHandle::timerEvent(QTimerEvent* event) {
    if (event->timerId() != m_timer.timerId()) return QWidget::timerEvent(event);
    update();
    if (!m_hold.due(SteadyTime::clock::now())) return;
    m_timer.stop();
    emit held(m_line.face.name);
}

void ReleaseHandle::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) begin();
}

void ReleaseHandle::mouseReleaseEvent(QMouseEvent* /*event*/) {
    end();
}

void ReleaseHandle::mouseMoveEvent(QMouseEvent* event) {
    if (m_hold.isHeld() && !rect().contains(event->position().toPoint())) end();
}

void ReleaseHandle::keyPressEvent(QKeyEvent* event) {
    if (!holdsBy(*event)) return QWidget::keyPressEvent(event);
    if (!event->isAutoRepeat()) begin();
}

void ReleaseHandle::keyReleaseEvent(QKeyEvent* event) {
    if (!holdsBy(*event)) return QWidget::keyReleaseEvent(event);
    if (!event->isAutoRepeat()) end();
}

void ReleaseHandle::focusOutEvent(QFocusEvent* event) {
    end();
    QWidget::focusOutEvent(event);
}

void ReleaseHandle::hideEvent(QHideEvent* event) {
    end();
    QWidget::hideEvent(event);
}

}  // namespace leitstand
