#include "widgets/robots/release_handle.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimerEvent>

#include "widgets/painting/pane_paint.h"
#include "widgets/robots/robot_bar_sizes.h"
#include "widgets/robots/robot_signs.h"

namespace leitstand {
namespace {

using robot_bar::Side, robot_bar::Sign, robot_bar::TextSize;
constexpr int Tick = 30;                           ///< [ms]
constexpr double SignLeft = 4.0, AfterSign = 3.0;  ///< [px]
constexpr double TextLeft = SignLeft + Sign + AfterSign;

bool holdsBy(const QKeyEvent& event) {
    return event.key() == Qt::Key_Space || event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

}  // namespace

ReleaseHandle::ReleaseHandle(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::TabFocus);  // needed for setTabOrder()
}

void ReleaseHandle::show(const StopLine& line) {
    if (m_line == line) return;
    m_line = line;
    setFocusPolicy(line.releasable ? Qt::TabFocus : Qt::NoFocus);
    setCursor(line.releasable ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (!line.releasable) end();
    QStringList hints = {line.text, line.details};
    if (line.releasable)
        hints += tr("Hold this button for one second to let %1 move again.").arg(line.face.title);
    hints.removeAll(QString());
    setToolTip(
        QStringLiteral("%1 (%2): %3").arg(line.face.title, line.face.letter, hints.join(QLatin1Char('\n'))));
    setAccessibleName(tr("Release %1").arg(line.face.title));
    setAccessibleDescription(line.text + QLatin1Char(' ') + line.details);
    setVisible(line.stage != StopStage::None);
    update();
}

int ReleaseHandle::foldedWidth(const QFont& font) {
    const QFontMetricsF metrics(sized(font, TextSize));
    double widest = 0.0;
    for (const QString& brief : stopBriefs()) widest = std::max(widest, metrics.horizontalAdvance(brief));
    return static_cast<int>(std::ceil(TextLeft + widest + Side));
}

QStringList ReleaseHandle::texts() const {
    QStringList texts;
    if (m_line.releasable) texts += tr("%1 · hold to release").arg(m_line.text);
    texts += m_line.text;
    texts += m_line.text.section(QStringLiteral(" · "), -1);  // "no answer for 2.9 s"
    texts += m_line.brief;
    return texts;
}

void ReleaseHandle::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColours& colours = coloursOf(presentTheme());
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(Qt::NoPen);
    // A stop to act on gets a filled surface, visible from afar.
    const bool loud = m_line.tone == Tone::Act;
    const QColor ink = loud ? colours.window : toneColour(m_line.tone, colours);
    const QColor paper = loud ? colours.act : m_line.releasable ? colours.hover : colours.strip;
    painter.setBrush(paper);
    painter.drawRoundedRect(box, 4, 4);
    if (const double share = m_hold.progress(SteadyTime::clock::now()); share > 0.0) {
        painter.setBrush(colours.chosen);
        painter.drawRoundedRect(QRectF(box.left(), box.top(), share * box.width(), box.height()), 4, 4);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(hasFocus() ? colours.select : m_line.releasable ? colours.muted : colours.line);
    painter.drawRoundedRect(box, 4, 4);
    paintStopSign(painter, QRectF(SignLeft, 0.5 * (height() - Sign), Sign, Sign), m_line, ink, paper);
    painter.setFont(sized(font(), TextSize));
    painter.setPen(ink);
    const QRectF room = QRectF(rect()).adjusted(TextLeft, 0, -Side, 0);
    const QFontMetricsF metrics(painter.font());
    const QStringList all = texts();
    const auto fits = [&](const QString& text) { return metrics.horizontalAdvance(text) <= room.width(); };
    const auto found = std::find_if(all.begin(), all.end(), fits);
    painter.drawText(room.adjusted(0, 0, 1, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     found == all.end() ? m_line.brief : *found);
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
    event->setAccepted(m_line.releasable);
    if (event->button() == Qt::LeftButton) begin();
}

void ReleaseHandle::mouseReleaseEvent(QMouseEvent* event) {
    event->setAccepted(m_line.releasable);
    end();
}

void ReleaseHandle::mouseMoveEvent(QMouseEvent* event) {
    event->setAccepted(m_line.releasable);
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
