#include "app/services/station/safety/station_alarms.h"

#include <algorithm>
#include <condition_variable>
#include <optional>
#include <utility>

#include <pthread.h>

#include "app/services/log/sequencer.h"
#include "core/base/time.h"
#include "core/event/event.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/mission/state/session_state.h"
#include "core/station/alarms/logged_alarm.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Rhythm(200);

std::size_t uncertain(const LiveMap& map) {
    return static_cast<std::size_t>(
        std::count_if(map.scans.begin(), map.scans.end(),
                      [](const LiveKeyScan& scan) { return scan.pose.trust == ScanTrust::Uncertain; }));
}

AlarmSample::State stateOf(AlarmChange::Kind kind) {
    switch (kind) {
        case AlarmChange::Kind::Raised:
            return AlarmSample::State::Raised;
        case AlarmChange::Kind::Acknowledged:
            return AlarmSample::State::Acknowledged;
        case AlarmChange::Kind::Ended:
            break;
    }
    return AlarmSample::State::Cleared;
}

}  // namespace

StationAlarms::StationAlarms(StationAlarmsSetup setup)
    : m_setup(std::move(setup)),
      m_book(m_setup.timing),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

StationAlarms::~StationAlarms() = default;

void StationAlarms::close() {
    m_thread.request_stop();
    if (m_thread.joinable()) m_thread.join();
}

void StationAlarms::onEvent(const Event& event) {
    const auto* bumps = event.sample.as<BumpSample>();
    if (bumps == nullptr) return;
    const std::lock_guard lock(m_mutex);
    const auto [known, first] = m_bumps.try_emplace(event.robot);
    Bump& bump = known->second;
    for (const Bumper& bumper : bumps->bumpers) {
        std::uint32_t& hits = bump.hits[bumper.name];
        // Hits from before the station listened are no news.
        if (bumper.pressed || (!first && bumper.hits > hits)) {
            bump.newest = bumper.name;
            bump.at = std::chrono::steady_clock::now();
        }
        hits = bumper.hits;
    }
}

void StationAlarms::endEarlier(const MissionState& mission, std::uint64_t session) const {
    for (const auto& [id, state] : *mission.alarms) {
        if (std::get<0>(id) != m_setup.station || state.alarm.state == AlarmSample::State::Cleared) continue;
        if (session > 0 && state.raised >= session) continue;  // an alarm of the log since it was opened
        AlarmSample over = state.alarm;
        over.stamp = stationTime();
        over.state = AlarmSample::State::Cleared;
        m_setup.onLog(over);
    }
}

void StationAlarms::addOfStation(const MissionState& mission, std::vector<AlarmCause>& causes) const {
    const std::uint64_t session = mission.sessions->empty() ? 0 : mission.sessions->back().started;
    for (const auto& [id, state] : *mission.alarms) {
        const AlarmSample& alarm = state.alarm;
        if (std::get<0>(id) != m_setup.station || state.raised < session || !isAlarmOfLog(alarm.key))
            continue;
        if (alarm.state == AlarmSample::State::Cleared) continue;
        causes.push_back(loggedCause(alarm));
    }
    if (const std::size_t scans = m_setup.scans ? uncertain(*m_setup.scans()) : 0; scans > 0) {
        causes.push_back({.id = {{}, alarm_key::UncertainScan, {}},
                          .severity = AlarmSeverity::Attention,
                          .value = static_cast<double>(scans),
                          .count = scans});
    }
}

std::vector<AlarmCause> StationAlarms::causes(const MissionState& mission, Time now) const {
    static const RobotState nothing;
    std::vector<AlarmCause> all;
    const RobotsInMapPtr places = m_setup.places ? m_setup.places() : std::make_shared<const RobotsInMap>();
    for (const RobotDescription& robot : m_setup.robots) {
        const auto reported = mission.robots.find(robot.name);
        const RobotView view = m_setup.view(robot.name);
        RobotWatch watch{robot, view, reported == mission.robots.end() ? nothing : *reported->second};
        for (const RobotInMap& place : *places) {
            if (place.robot == robot.name) watch.spinning = place.spinning;
        }
        const std::lock_guard lock(m_mutex);
        if (const auto bump = m_bumps.find(robot.name); bump != m_bumps.end() && bump->second.at) {
            watch.bumpAge = toSeconds(std::chrono::steady_clock::now() - *bump->second.at);
            watch.bumper = bump->second.newest;
        }
        std::vector<AlarmCause> some = alarmsOf(watch, m_book, now, m_setup.limits);
        all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
    }
    addOfStation(mission, all);
    return all;
}

void StationAlarms::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "alarms");
    std::optional<std::uint64_t> ended;  // alarms before this session are ended; it may not be known at once
    std::mutex asleep;
    std::condition_variable_any never;
    auto next = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
        const Time now = stationTime();
        const MissionStatePtr mission = m_setup.mission();
        const std::uint64_t session = mission->sessions->empty() ? 0 : mission->sessions->back().started;
        if (ended != session) endEarlier(*mission, session);
        ended = session;
        const std::vector<AlarmCause> present = causes(*mission, now);
        std::vector<AlarmChange> changes;
        {
            const std::lock_guard lock(m_mutex);
            changes = m_book.update(present, now);
        }
        log(changes, now);
        next = std::max(next + Rhythm, std::chrono::steady_clock::now());
        std::unique_lock lock(asleep);
        never.wait_until(lock, stop, next, [] { return false; });
    }
}

void StationAlarms::log(const std::vector<AlarmChange>& changes, Time now) const {
    for (const AlarmChange& change : changes) {
        const bool ofLog = change.cause.id.key == alarm_key::Log;
        if (ofLog && change.kind != AlarmChange::Kind::Acknowledged) continue;  // logged already
        const bool act = change.cause.severity == AlarmSeverity::Act;
        m_setup.onLog({.stamp = now,
                       .station = m_setup.station,
                       .robot = change.cause.id.robot,
                       .key = ofLog ? change.cause.id.detail : logKey(change.cause.id),
                       .severity = act ? AlarmSample::Severity::Critical : AlarmSample::Severity::Warning,
                       .state = stateOf(change.kind),
                       .text = logText(change.cause)});
    }
}

void StationAlarms::acknowledge(const AlarmId& id) {
    const Time now = stationTime();
    std::vector<AlarmChange> changes;
    {
        const std::lock_guard lock(m_mutex);
        changes = m_book.acknowledge(id, now);
    }
    log(changes, now);
}

void StationAlarms::acknowledgeNewest() {
    const Time now = stationTime();
    std::vector<AlarmChange> changes;
    {
        const std::lock_guard lock(m_mutex);
        changes = m_book.acknowledgeNewest(now);
    }
    log(changes, now);
}

void StationAlarms::mute(std::chrono::nanoseconds time) {
    const std::lock_guard lock(m_mutex);
    m_book.mute(stationTime() + time);
}

AlarmsView StationAlarms::view() const {
    const std::lock_guard lock(m_mutex);
    AlarmsView view{m_book.alarms(), m_book.attentions(), false, m_book.mutedUntil()};
    view.loud =
        std::any_of(view.alarms.begin(), view.alarms.end(), [](const Alarm& one) { return one.isLoud(); });
    return view;
}

}  // namespace leitstand
