#include "widgets/timeline/timeline_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/models/times.h"
#include "widgets/painting/pane_paint.h"
#include "widgets/timeline/mark_glyph.h"

namespace leitstand {
namespace {

constexpr double Side = 14.0;                         ///< margin left and right of the track [px]
constexpr double FindsAt = 13.0, OthersAt = 34.0;     ///< middles of the lanes [px]
constexpr double LaneEnd = 23.5;                      ///< between them [px]
constexpr double TrackTop = 49.0, TrackHeight = 8.0;  ///< [px]
constexpr double LabelsTop = 60.0;
constexpr double Reach = 8.0;         ///< how far a click may miss a mark [px]
constexpr double TickSpacing = 84.0;  ///< [px]
constexpr int LabelSize = 11;

bool isFind(const TimelineGlyph& glyph) {
    return glyph.shape == MarkShape::Disc || glyph.shape == MarkShape::Drop;
}

}  // namespace

TimelineBar::TimelineBar(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("timeline"));
    setAccessibleName(tr("Timeline of the mission"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Click or drag to go to a moment; arrows step by 1 s, with Shift by 10 s"));
}

void TimelineBar::setMission(const TimelineAxis& axis, std::vector<TimelineGlyph> glyphs) {
    m_axis = axis;
    m_glyphs = std::move(glyphs);
    m_opening = 1.0;
    update();
}

void TimelineBar::setPosition(Time at) {
    if (at == m_position) return;
    m_position = at;
    setAccessibleDescription(wallText(at));
    update();
}

void TimelineBar::setOpening(double fraction, const QString& doing) {
    m_opening = fraction;
    m_doing = doing;
    setAccessibleDescription(doing);
    update();
}

QRectF TimelineBar::track() const {
    return {Side, TrackTop, std::max(1.0, width() - 2.0 * Side), TrackHeight};
}

double TimelineBar::pixelOf(Time at) const {
    return track().left() + m_axis.placeOf(at) * track().width();
}

Time TimelineBar::timeAt(double x) const {
    return m_axis.timeAt((x - track().left()) / track().width());
}

const TimelineGlyph* TimelineBar::glyphAt(const QPointF& point) const {
    if (point.y() > TrackTop + TrackHeight) return nullptr;
    const bool finds = point.y() < LaneEnd;
    const TimelineGlyph* nearest = nullptr;
    double least = Reach;
    for (const TimelineGlyph& glyph : m_glyphs) {
        if (isFind(glyph) != finds) continue;
        const double distance = std::abs(track().left() + glyph.place * track().width() - point.x());
        if (distance > least) continue;
        least = distance;
        nearest = &glyph;
    }
    return nearest;
}

void TimelineBar::paintTicks(QPainter& painter) const {
    const ThemeColours& colours = coloursOf(presentTheme());
    painter.setFont(sized(font(), LabelSize));
    const QFontMetricsF metrics(painter.font());
    for (const TimelineAxis::Tick& tick : m_axis.ticks(TickSpacing / track().width())) {
        const double x = track().left() + tick.place * track().width();
        painter.setPen(colours.line);
        painter.drawLine(QPointF(x, TrackTop + TrackHeight), QPointF(x, LabelsTop + 2.0));
        const QString text = wallText(tick.at);
        const double wide = metrics.horizontalAdvance(text) + 2.0;
        const double left = std::clamp(x - 0.5 * wide, 2.0, std::max(2.0, width() - wide - 2.0));
        painter.setPen(colours.muted);
        painter.drawText(QRectF(left, LabelsTop, wide, height() - LabelsTop), Qt::AlignCenter, text);
    }
}

void TimelineBar::paintGlyphs(QPainter& painter) const {
    // The most important is painted last. Finds have a lane of their own, where alarms do not hide them.
    for (const Tone tone : {Tone::Muted, Tone::Normal, Tone::Attention, Tone::Act}) {
        for (const TimelineGlyph& glyph : m_glyphs) {
            if (isFind(glyph) || glyph.tone != tone) continue;
            const double x = track().left() + glyph.place * track().width();
            paintMark(painter, glyph, {x, OthersAt}, font());
        }
    }
    for (const MarkShape shape : {MarkShape::Drop, MarkShape::Disc}) {
        for (const TimelineGlyph& glyph : m_glyphs) {
            if (glyph.shape != shape) continue;
            paintMark(painter, glyph, {track().left() + glyph.place * track().width(), FindsAt}, font());
        }
    }
}

void TimelineBar::paintPosition(QPainter& painter) const {
    const ThemeColours& colours = coloursOf(presentTheme());
    const double x = pixelOf(m_position);
    QRectF done = track();
    done.setRight(x);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.select);
    painter.drawRoundedRect(done, 3, 3);
    painter.setPen(QPen(colours.text, 2.0));
    painter.drawLine(QPointF(x, 2.0), QPointF(x, TrackTop + TrackHeight + 3.0));
    const std::array<QPointF, 3> handle = {QPointF(x - 6, TrackTop + TrackHeight + 9),
                                           QPointF(x + 6, TrackTop + TrackHeight + 9),
                                           QPointF(x, TrackTop + TrackHeight)};
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.text);
    painter.drawPolygon(handle.data(), static_cast<int>(handle.size()));
}

void TimelineBar::paintEvent(QPaintEvent* /*event*/) {
    const ThemeColours& colours = coloursOf(presentTheme());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), colours.strip);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.field);
    painter.drawRoundedRect(track(), 3, 3);
    if (m_opening < 1.0 || m_axis.empty()) {
        QRectF read = track();
        read.setWidth(m_opening * read.width());
        painter.setBrush(colours.muted);
        painter.drawRoundedRect(read, 3, 3);
        painter.setPen(colours.muted);
        painter.setFont(sized(font(), LabelSize));
        painter.drawText(QRectF(Side, LabelsTop, width() - 2 * Side, height() - LabelsTop), Qt::AlignLeft,
                         m_doing.isEmpty() ? tr("reads through the mission…") : m_doing);
        return;
    }
    paintTicks(painter);
    paintPosition(painter);
    for (const auto& [from, to] : m_axis.gaps()) {
        const QRectF gap(track().left() + from * track().width(), TrackTop - 2.0,
                         std::max(3.0, (to - from) * track().width()), TrackHeight + 4.0);
        painter.fillRect(gap, colours.strip);
        painter.fillRect(gap, QBrush(colours.muted, Qt::BDiagPattern));
    }
    paintGlyphs(painter);
    if (hasFocus()) {
        painter.setPen(QPen(colours.select, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
    }
}

void TimelineBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_axis.empty()) return;
    if (const TimelineGlyph* const glyph = glyphAt(event->position());
        glyph != nullptr && event->position().y() < TrackTop) {
        emit sought(glyph->mark.at);
        return;
    }
    m_dragging = true;
    emit sought(timeAt(event->position().x()));
}

void TimelineBar::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging) emit sought(timeAt(event->position().x()));
}

void TimelineBar::mouseReleaseEvent(QMouseEvent* /*event*/) {
    m_dragging = false;
}

void TimelineBar::keyPressEvent(QKeyEvent* event) {
    const double step = (event->modifiers() & Qt::ShiftModifier) != 0 ? 10.0 : 1.0;
    switch (event->key()) {
        case Qt::Key_Left:
            return emit stepped(-step);
        case Qt::Key_Right:
            return emit stepped(step);
        case Qt::Key_Home:
            return emit sought(m_axis.first());
        case Qt::Key_End:
            return emit sought(m_axis.last());
        default:
            QWidget::keyPressEvent(event);
    }
}

bool TimelineBar::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || m_axis.empty()) return QWidget::event(event);
    const auto* const help = static_cast<QHelpEvent*>(event);
    const TimelineGlyph* const glyph = glyphAt(help->pos());
    QToolTip::showText(help->globalPos(),
                       glyph != nullptr ? glyph->details : wallText(timeAt(help->pos().x())), this);
    return true;
}

}  // namespace leitstand
