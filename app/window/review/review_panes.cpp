#include "app/window/review/review_panes.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include <QMainWindow>

#include "app/window/live/frame/pane_docks.h"
#include "app/window/live/input/selection.h"
#include "app/window/review/review_bridge.h"
#include "core/mission/state/mission_clock.h"
#include "widgets/alarms/alarm_panel.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/link/stream_list.h"
#include "widgets/mission/clock_face.h"
#include "widgets/models/live/robots/drive_state.h"
#include "widgets/models/live/robots/stream_rows.h"
#include "widgets/models/live/texts/alarm_words.h"
#include "widgets/models/live/texts/clock_text.h"

namespace leitstand {

ReviewPanes::ReviewPanes(const ViewContext& context, ReviewBridge& bridge)
    : QObject(&context.window),
      m_context(context),
      m_bridge(bridge),
      m_strip(new DriveStrip(&context.window)),
      m_alarms(new AlarmPanel(&context.window)),
      m_streams(new StreamList(StreamTable::Of::Log, &context.window)),
      m_clock(new ClockFace(&context.window)) {
    m_alarms->setReadOnly(true);
    context.panes.add(QStringLiteral("strip"), tr("Robot"), *m_strip);
    context.panes.keepInSight(QStringLiteral("strip"));
    context.panes.add(QStringLiteral("alarms"), tr("Alarms"), *m_alarms);
    context.panes.add(QStringLiteral("link"), tr("Link"), *m_streams);
    connect(&context.source, &MomentSource::ticked, this, &ReviewPanes::show);
}

GasTrend ReviewPanes::gasUntil(const std::string& robot, Time now) const {
    GasTrend trend;
    const auto said = m_bridge.index()->gas.find(robot);
    if (said == m_bridge.index()->gas.end()) return trend;
    const auto span =
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(GasTrend::Span));
    auto one = std::lower_bound(said->second.begin(), said->second.end(), std::pair(now - span, -1.0));
    for (; one != said->second.end() && one->first <= now; ++one) trend.add(one->first, one->second);
    return trend;
}

QWidget* ReviewPanes::clock() const {
    return m_clock;
}

void ReviewPanes::showStrip(const LiveMoment& moment) {
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return;
    DriveState state = driveStateOf(m_context.selection.face(), *robot, moment.view(robot->name),
                                    moment.said(robot->name), gasUntil(robot->name, moment.now), moment.now);
    state.grant.choice = GrantFigures::Choice::None;  // nobody can be asked for it any more
    m_strip->show(state);
}

void ReviewPanes::showStreams(const LiveMoment& moment) {
    if (!m_streams->isVisible()) return;
    std::vector<StreamRow> rows;
    for (const RobotDescription& robot : m_context.selection.robots()) {
        appendStreamRows(rows, m_context.selection.faceOfRobot(robot), robot, moment.view(robot.name).link,
                         [](const std::string&) { return StreamSetting(); });
    }
    m_streams->setRows(std::move(rows));
}

void ReviewPanes::show(const LiveMoment& moment) {
    showStrip(moment);
    showStreams(moment);
    m_clock->show(clockText(clockAt(
        moment.mission->clock ? std::optional(moment.mission->clock->sample) : std::nullopt, moment.now)));
    std::vector<RobotFace> faces;
    for (const RobotDescription& robot : m_context.selection.robots())
        faces.push_back(m_context.selection.faceOfRobot(robot));
    m_alarms->show(alarmLinesOf(m_bridge.reviewed()->alarms, faces, moment.now), {});
}

}  // namespace leitstand
