#include "app/services/review/reviewed_robot.h"

#include <algorithm>

#include "core/base/time.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/robot_state.h"
#include "core/mission/state/session_state.h"
#include "core/station/alarms/logged_alarm.h"

namespace leitstand {
namespace {

constexpr double LostAfter = 3.0;  ///< of silence [s], as in a live station

LinkStatus linkOf(const RobotDescription& robot, const RobotState* reported, Time now) {
    LinkStatus link;
    link.robot = robot.name;
    if (reported == nullptr) return link;
    Time newest{};
    for (const auto& [topic, stream] : reported->streams) {
        if (stream.role && !isCommand(*stream.role)) newest = std::max(newest, stream.received);
    }
    if (newest == Time{}) return link;
    link.silence = std::max(0.0, secondsBetween(newest, now));
    link.state = link.silence > LostAfter ? LinkState::Lost : LinkState::Connected;
    link.stateAge = link.state == LinkState::Lost ? link.silence - LostAfter : 0.0;
    return link;
}

StopStatus stopOf(const RobotDescription& robot, const RobotState* reported) {
    StopStatus stop;
    stop.supported = robot.stream(StreamRole::StopCommand) != nullptr;
    if (reported == nullptr || !reported->stop) return stop;
    const StopStateSample& state = reported->stop->sample;
    stop.stopped = state.stopped;
    stop.standing = state.standing;
    stop.standingKnown = true;
    stop.stoppedBy = state.station;
    stop.refused = state.refused;
    return stop;
}

}  // namespace

RobotView reviewedRobot(const RobotDescription& robot, const MissionState& state, Time now) {
    const auto found = state.robots.find(robot.name);
    const RobotState* const reported = found == state.robots.end() ? nullptr : &*found->second;
    RobotView view;
    view.link = linkOf(robot, reported, now);
    view.stop = stopOf(robot, reported);
    view.drive.drivable = robot.stream(StreamRole::DriveCommand) != nullptr ||
                          robot.stream(StreamRole::TrackCommand) != nullptr;
    const auto grant = state.grants->find({GrantSample::Kind::Drive, robot.name});
    if (grant != state.grants->end()) {
        view.grant.holder = grant->second.station;
        view.grant.holderTitle = grant->second.title;
    }
    return view;
}

std::vector<Alarm> reviewedAlarms(const MissionState& state, Time now) {
    const AlarmTiming timing;
    std::vector<Alarm> alarms;
    for (const auto& [key, kept] : *state.alarms) {
        const AlarmSample& reported = kept.alarm;
        Alarm alarm;
        alarm.cause = loggedCause(reported);
        alarm.number = kept.raised;
        alarm.since = reported.stamp;
        alarm.acknowledged = reported.state == AlarmSample::State::Acknowledged;
        if (reported.state == AlarmSample::State::Cleared) {
            if (now - reported.stamp > timing.shown) continue;
            alarm.ended = reported.stamp;
        }
        alarms.push_back(std::move(alarm));
    }
    std::sort(alarms.begin(), alarms.end(), [](const Alarm& a, const Alarm& b) {
        if (a.ended.has_value() != b.ended.has_value()) return !a.ended;
        return a.number > b.number;
    });
    return alarms;
}

}  // namespace leitstand
