#include "widgets/pad/pad_legend.h"

#include <algorithm>
#include <utility>

#include <QMouseEvent>

#include "widgets/models/pad/pad_callouts.h"
#include "widgets/pad/pad_drawing.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

constexpr int Margin = 16, Head = 56, Foot = 36;  ///< [px]
constexpr int HelpHead = 84, HelpFoot = 58;       ///< while no pad is connected [px]
constexpr int LineHeight = 34;

/// Returns the callouts that have a text, in the order of their spots from the top.
std::vector<PadCallout> bound(std::vector<PadCallout> all, const QRectF& drawing) {
    std::erase_if(all, [](const PadCallout& one) { return one.does.isEmpty(); });
    std::stable_sort(all.begin(), all.end(), [&](const PadCallout& one, const PadCallout& other) {
        return padSpotAt(one.spot, drawing).y() < padSpotAt(other.spot, drawing).y();
    });
    return all;
}

/// Paints the name of a control, small, and below it what the control does.
void paintCallout(QPainter& painter, const QRectF& box, const PadCallout& callout, Qt::Alignment side,
                  const ThemeColours& colours) {
    const QFont font = painter.font();
    const QRectF upper(box.left(), box.top(), box.width(), 14),
        lower(box.left(), box.top() + 14, box.width(), 18);
    painter.setFont(sized(font, 11));
    painter.setPen(colours.muted);
    painter.drawText(
        upper, side | Qt::AlignVCenter,
        painter.fontMetrics().elidedText(callout.control, Qt::ElideRight, static_cast<int>(upper.width())));
    painter.setFont(fitted(font, callout.does, lower.width(), 13, 10, callout.stop || callout.held));
    painter.setPen(callout.held ? colours.select : colours.text);
    painter.drawText(
        lower, side | Qt::AlignVCenter,
        painter.fontMetrics().elidedText(callout.does, Qt::ElideRight, static_cast<int>(lower.width())));
    painter.setFont(font);
}

void paintSide(QPainter& painter, const QRectF& column, const QRectF& drawing,
               const std::vector<PadCallout>& callouts, bool left, const ThemeColours& colours) {
    const double step =
        std::min(double{LineHeight} + 16.0,
                 column.height() / std::max<double>(1.0, static_cast<double>(callouts.size())));
    double y = column.top();
    for (const PadCallout& callout : callouts) {
        const QRectF box(column.left(), y, column.width(), LineHeight);
        const QPointF spot = padSpotAt(callout.spot, drawing);
        const QPointF edge(left ? box.right() + 8 : box.left() - 8, box.top() + 22);
        const QPointF bend(left ? drawing.left() - 12 : drawing.right() + 12, edge.y());
        painter.setPen(QPen(callout.stop   ? colours.stop
                            : callout.held ? colours.select
                                           : colours.muted,
                            1.0));
        painter.drawPolyline(QPolygonF({edge, bend, spot}));
        paintCallout(painter, box, callout, left ? Qt::AlignRight : Qt::AlignLeft, colours);
        y += step;
    }
}

}  // namespace

PadLegend::PadLegend(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Controls of the gamepad"));
    setToolTip(tr("What the gamepad's controls do; a click closes this"));
}

void PadLegend::setPad(const QString& name, const PadBindings& bindings) {
    m_name = name;
    m_bindings = bindings;
    QStringList words;
    for (const PadCallout& one : padList(bindings, m_commands, {}))
        words += one.control + QStringLiteral(": ") + one.does;
    if (name.isEmpty()) words = QStringList{padConnectHelp(), padlessKeys()} + words;
    setAccessibleDescription(words.join(QStringLiteral("; ")));
    update();
}

void PadLegend::setCommands(std::vector<PadCommandFace> commands) {
    m_commands = std::move(commands);
    setPad(m_name, m_bindings);
}

void PadLegend::setState(const PadState& state) {
    if (state == m_state) return;
    m_state = state;
    update();
}

QSize PadLegend::sizeHint() const {
    return {860, 460};
}

void PadLegend::mousePressEvent(QMouseEvent* event) {
    event->accept();
    emit clicked();
}

void PadLegend::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColours& colours = coloursOf(presentTheme());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(colours.line);
    painter.setBrush(colours.pane);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8, 8);
    const QRectF room = QRectF(rect()).adjusted(Margin, 0, -Margin, 0);
    painter.setFont(sized(font(), 15, true));
    painter.setPen(colours.text);
    painter.drawText(QRectF(room.left(), 10, room.width(), 22), Qt::AlignLeft | Qt::AlignVCenter,
                     m_name.isEmpty() ? tr("Gamepad: none is plugged in") : tr("Gamepad: %1").arg(m_name));
    painter.setFont(sized(font(), 12));
    painter.setPen(colours.muted);
    const bool none = m_name.isEmpty();
    paintWrapped(painter, {room.left(), 32, room.width(), none ? HelpHead - 36.0 : 18.0},
                 none ? padConnectHelp() : padDriveHint(m_bindings), none ? 3 : 1);
    const double foot = none ? HelpFoot : Foot;
    paintWrapped(painter, {room.left(), height() - foot + 8, room.width(), foot - 12},
                 none ? padlessKeys()
                      : tr("The trigger held and the window in front: the pad drives. STOP works always."),
                 none ? 3 : 1);
    painter.setFont(sized(font(), 13));
    const QRectF inner = room.adjusted(0, none ? HelpHead : Head, 0, -foot);
    if (m_bindings.layout == PadLayout::Standard) {
        paintStandard(painter, inner);
    } else {
        paintList(painter, inner);
    }
}

void PadLegend::paintStandard(QPainter& painter, const QRectF& room) const {
    const ThemeColours& colours = coloursOf(presentTheme());
    const double width = std::min(0.5 * room.width(), room.height() * PadAspect);
    const QRectF drawing(room.center().x() - width / 2, room.center().y() - width / PadAspect / 2, width,
                         width / PadAspect);
    const PadCallouts callouts = padCallouts(m_bindings, m_commands, m_state);
    const double column = drawing.left() - room.left() - 28;
    const auto left = bound(callouts.left, drawing), right = bound(callouts.right, drawing);
    drawPadBody(painter, drawing, colours);
    // Lines go below the controls, which stay legible.
    paintSide(painter, {room.left(), room.top(), column, room.height()}, drawing, left, true, colours);
    paintSide(painter, {room.right() - column, room.top(), column, room.height()}, drawing, right, false,
              colours);
    drawPadControls(painter, drawing, callouts, m_state, colours);
}

void PadLegend::paintList(QPainter& painter, const QRectF& room) const {
    const ThemeColours& colours = coloursOf(presentTheme());
    const auto list = padList(m_bindings, m_commands, m_state);
    const int perColumn = std::max(1, static_cast<int>(room.height()) / (LineHeight + 4));
    const int columns = std::max(1, (static_cast<int>(list.size()) + perColumn - 1) / perColumn);
    const double width = room.width() / columns;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const int at = static_cast<int>(i);
        const QRectF box(room.left() + width * (at / perColumn),
                         room.top() + (at % perColumn) * (LineHeight + 4), width - 12, LineHeight);
        if (list[i].stop) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(colours.stop);
            painter.drawRect(QRectF(box.left(), box.top(), 3, box.height()));
        }
        paintCallout(painter, box.adjusted(10, 0, 0, 0), list[i], Qt::AlignLeft, colours);
    }
}

}  // namespace leitstand
