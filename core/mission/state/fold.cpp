#include "core/mission/state/fold.h"

#include <algorithm>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/time.h"
#include "core/event/all_samples.h"
#include "core/event/candidate_sample.h"
#include "core/event/cloud_sample.h"
#include "core/event/command_samples.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/event/status_samples.h"
#include "core/mission/markers/marker_board.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/decisions.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/session_state.h"

namespace leitstand {

namespace {

/// Returns the sender's time of a sample; epoch when it has none.
template <class T>
Time stampOf(const T& sample) {
    if constexpr (requires { sample.header.stamp; }) {
        return sample.header.stamp;
    } else if constexpr (requires {
                             { sample.stamp } -> std::convertible_to<Time>;
                         }) {
        return sample.stamp;
    } else {
        return {};
    }
}

/// Replaces the earlier status of the same part. Beyond a sane number of parts, drops the one that was silent
/// longest.
void mergeStatus(std::vector<DiagnosticStatus>& statuses, const DiagnosticStatus& status) {
    constexpr std::size_t MostParts = 256;
    std::erase_if(statuses, [&](const DiagnosticStatus& known) { return known.name == status.name; });
    if (statuses.size() == MostParts) statuses.erase(statuses.begin());
    statuses.push_back(status);
}

class Step {
public:
    Step(MissionState& state, const Event& event) : m_state(state), m_event(event) {}

    void take() {
        countStream();
        visit([this](const auto& sample) { handle(sample); }, m_event.sample);
    }

private:
    RobotState& robot() { return m_state.robots[m_event.robot].edit(); }

    template <class T>
    LatestPtr<T> latest(T sample) const {
        return latestPtr(Latest<T>{m_event.sequence, m_event.received, std::move(sample)});
    }

    void countStream() {
        auto& streams = m_event.robot.empty() ? m_state.ownTopics.edit() : robot().streams;
        StreamState& stream = streams[m_event.topic];
        stream.role = m_event.role;
        stream.sensor = m_event.sensor;
        ++stream.events;
        stream.sequence = m_event.sequence;
        stream.received = m_event.received;
        stream.stamp = visit([](const auto& sample) { return stampOf(sample); }, m_event.sample);
    }

    /// Puts @p sample into a robot's state; ignores samples without a robot.
    template <class T>
    void keep(LatestPtr<T> RobotState::*place, const T& sample) {
        if (!m_event.robot.empty()) robot().*place = latest(sample);
    }

    void decided(decltype(Decision::content) content) {
        decide(m_state, {m_event.sequence, m_event.received, false, std::move(content)});
    }

    /// Adds the hits of @p sample beyond those counted before. A restarted robot counts from zero.
    void countContacts(const BumpSample& sample) {
        RobotState& state = robot();
        for (const Bumper& bumper : sample.bumpers) {
            // The first count may include hits before the mission, except what is pressed now.
            std::uint32_t before = 0;
            if (!state.bumps) before = bumper.hits - (bumper.pressed && bumper.hits > 0 ? 1 : 0);
            if (state.bumps) {
                for (const Bumper& known : state.bumps->sample.bumpers) {
                    if (known.name == bumper.name) before = known.hits;
                }
            }
            if (bumper.hits < before) before = 0;
            if (bumper.hits == before || state.contacts.size() >= RobotState::MostContacts) continue;
            std::optional<Pose> place;
            if (state.odometry) place = state.odometry->sample.baseInOdom;
            state.contacts.push_back(
                {m_event.sequence, m_event.received, bumper.name, bumper.hits - before, place});
        }
    }

    /// Returns who reports @p sample, and how that robot drives now.
    FirstReport firstReportNow(const CandidateSample& sample) const {
        FirstReport firstReport{.stamp = sample.stamp, .robot = {}, .autonomous = {}};
        if (sample.cues.empty()) return firstReport;
        firstReport.robot = sample.cues.front().robot;
        const auto robot = m_state.robots.find(firstReport.robot);
        if (robot != m_state.robots.end() && robot->second->mode)
            firstReport.autonomous = robot->second->mode->sample.autonomous;
        return firstReport;
    }

    /// Takes @p sample into the mean current of the battery. A robot that rests takes little and one that
    /// starts takes much: neither shows how long the battery lasts.
    void weigh(const BatterySample& sample) {
        RobotState& state = robot();
        const bool goesOn = state.battery && state.load.current < 0.0 && sample.current < 0.0;
        if (!goesOn) {
            state.load = {.current = sample.current, .seconds = BatteryLoad::AtFirst};
            return;
        }
        const double since = toSeconds(m_event.received - state.battery->received);
        const double step = std::clamp(since, 0.0, BatteryLoad::Longest);
        state.load.seconds = std::min(state.load.seconds + step, BatteryLoad::Longest);
        state.load.current += (sample.current - state.load.current) * step / state.load.seconds;
    }

    void handle(const OdometrySample& sample) {
        OdometrySample kept = sample;
        kept.poseCovariance = kept.twistCovariance = {};
        keep(&RobotState::odometry, kept);
    }
    void handle(const ImuSample& sample) {
        ImuSample kept = sample;
        kept.orientationCovariance = kept.angularVelocityCovariance = kept.linearAccelerationCovariance = {};
        keep(&RobotState::imu, kept);
    }
    void handle(const ModeSample& sample) { keep(&RobotState::mode, sample); }
    void handle(const BatterySample& sample) {
        if (m_event.robot.empty()) return;
        weigh(sample);
        keep(&RobotState::battery, sample);
    }
    void handle(const GasSample& sample) { keep(&RobotState::gas, sample); }
    void handle(const ReadingSample& sample) {
        if (!m_event.robot.empty()) robot().readings[m_event.topic] = latest(sample);
    }
    void handle(const MarkersSample& sample) {
        if (m_event.robot.empty()) return;
        RobotState& state = robot();
        auto& kept = state.markers[m_event.topic];
        MarkerBoard board = kept ? kept->sample : MarkerBoard{};
        board.take(sample, m_event.received,
                   state.odometry ? state.odometry->sample.baseInOdom : Pose::Identity());
        kept = latest(std::move(board));
    }
    void handle(const RobotModelSample& sample) { keep(&RobotState::model, sample); }
    void handle(const DetectionsSample& sample) {
        if (!m_event.robot.empty()) robot().detections[m_event.topic] = latest(sample);
    }
    void handle(const BumpSample& sample) {
        if (m_event.robot.empty()) return;
        countContacts(sample);
        keep(&RobotState::bumps, sample);
    }
    void handle(const SightingSample& sample) { keep(&RobotState::sightings, sample); }
    void handle(const DiagnosticsSample& sample) {
        if (m_event.robot.empty() || sample.statuses.empty()) return;  // a message about other robots
        auto& kept = robot().diagnostics;
        DiagnosticsSample merged = kept ? kept->sample : DiagnosticsSample{};
        merged.header = sample.header;
        for (const DiagnosticStatus& status : sample.statuses) mergeStatus(merged.statuses, status);
        kept = latest(std::move(merged));
    }
    /// Keeps the transforms that lead from the odometry's frame upwards. All others are only counted.
    void handle(const TransformsSample& sample) {
        if (m_event.robot.empty()) return;
        RobotState& state = robot();
        if (!state.odometry) return;
        auto& above = state.framesAbove;
        const auto isParent = [&](const std::string& frame) {
            return std::any_of(above.begin(), above.end(),
                               [&](const auto& known) { return known.second.parent == frame; });
        };
        for (const FrameTransform& one : sample.transforms) {
            const bool leadsUp =
                one.childFrame == state.odometry->sample.header.frame || isParent(one.childFrame);
            if (!leadsUp) continue;
            if (above.size() >= RobotState::MostFramesAbove && !above.contains(one.childFrame)) continue;
            above[one.childFrame] = {one.header.frame, one.childInParent};
        }
    }
    void handle(const OccupancyGridSample& sample) {
        if (!m_event.robot.empty()) robot().grids[m_event.topic] = latest(sample);
    }
    /// Changes a copy of the grid. What does not fit the grid belongs to one that was not received. Of a huge
    /// grid, only whole ones count: each update copies it, however small it is.
    void handle(const GridUpdateSample& update) {
        constexpr std::string_view Ending = "_updates";
        constexpr std::size_t MostCopied = 4'000'000;  // cells
        if (m_event.robot.empty() || !m_event.topic.ends_with(Ending)) return;
        auto& grids = robot().grids;
        const auto found = grids.find(m_event.topic.substr(0, m_event.topic.size() - Ending.size()));
        if (found == grids.end() || found->second->sample.cells.size() > MostCopied) return;
        OccupancyGridSample grid = found->second->sample;
        if (update.x > grid.width - update.width || update.y > grid.height - update.height) return;
        grid.header.stamp = update.header.stamp;
        for (int row = 0; row < update.height; ++row) {
            const auto from = update.cells.begin() + std::ptrdiff_t(row) * update.width;
            const auto to = grid.cells.begin() + std::ptrdiff_t(update.y + row) * grid.width + update.x;
            std::copy_n(from, update.width, to);
        }
        found->second = latest(std::move(grid));
    }
    void handle(const PathSample& sample) {
        if (!m_event.robot.empty()) robot().paths[m_event.topic] = latest(sample);
    }
    void handle(const StopStateSample& sample) { keep(&RobotState::stop, sample); }
    void handle(const StopCommandSample& sample) { keep(&RobotState::stopCommand, sample); }
    void handle(const ClockOffsetSample& sample) {
        if (!sample.robot.empty()) m_state.robots[sample.robot].edit().clockOffset = latest(sample);
    }
    void handle(const RobotPlaceSample& sample) {
        if (!sample.robot.empty()) m_state.robots[sample.robot].edit().place = latest(sample);
    }
    void handle(const ClockSample& sample) { m_state.clock = latest(sample); }
    void handle(const MissionInfoSample& sample) { m_state.info = latest(sample); }
    void handle(const CandidateSample& sample) {
        CandidateState& candidate = m_state.candidates.edit()[sample.id];
        if (candidate.first == 0) {
            candidate.first = m_event.sequence;
            candidate.firstReport = firstReportNow(sample);
        }
        candidate.sequence = m_event.sequence;
        candidate.candidate = sample;
    }

    void handle(const FindSample& sample) { decided(sample); }
    void handle(const NoteSample& sample) { decided(sample); }
    void handle(const ScanPosesSample& sample) { decided(sample); }
    void handle(const MapCropSample& sample) { decided(sample); }
    void handle(const ScanBodiesSample& sample) { decided(sample); }
    void handle(const ScanLinksSample& sample) {
        // Links of registration go with their scan; only loops can be taken back.
        ScanLinksSample loops = sample;
        std::erase_if(loops.links, [](const Link& link) { return !closesLoop(link.kind); });
        if (!loops.links.empty()) decided(std::move(loops));
    }
    void handle(const UndoSample& sample) { decided(sample); }
    void handle(const KeyScanSample& sample) {
        KeyScanEntry entry;
        entry.id = sample.id;
        entry.robot = sample.scan ? sample.scan->robot : m_event.robot;
        entry.stamp = sample.stamp;
        entry.sensorInBase = sample.sensorInBase;
        entry.scanInMap = sample.scanInMap;
        if (sample.scan && sample.scan->hasOdometry) entry.sensorInOdom = sample.scan->sensorInOdom;
        entry.matched = sample.matched;
        entry.points = sample.scan ? sample.scan->points.size() : 0;
        decided(std::move(entry));
    }

    void handle(const GrantSample& sample) {
        GrantState& grant = m_state.grants.edit()[{sample.kind, sample.robot}];
        switch (sample.action) {
            case GrantSample::Action::Hold:
                if (sample.term < grant.term) break;  // a superseded holder that does not know it yet
                grant.station = sample.station;
                grant.title = sample.title;
                grant.term = sample.term;
                grant.heartbeat = m_event.received;
                if (grant.requestedBy == sample.station) grant.requestedBy.clear();
                break;
            case GrantSample::Action::Request:
                grant.requestedBy = sample.station;
                break;
            case GrantSample::Action::Consent:
            case GrantSample::Action::Refuse:
                if (grant.requestedBy == sample.other) grant.requestedBy.clear();
                if (sample.action == GrantSample::Action::Refuse) break;
                [[fallthrough]];
            case GrantSample::Action::Release:
                if (grant.station != sample.station) break;
                grant.station.clear();
                grant.title.clear();
                break;
        }
    }

    void handle(const AlarmSample& sample) {
        AlarmState& alarm = m_state.alarms.edit()[{sample.station, sample.robot, sample.key}];
        alarm.sequence = m_event.sequence;
        alarm.alarm = sample;
        if (sample.state != AlarmSample::State::Raised) return;
        alarm.raised = m_event.sequence;
        ++alarm.times;
    }

    void handle(const SessionSample& sample) {
        auto& sessions = m_state.sessions.edit();
        if (sample.start) {
            sessions.push_back({m_event.sequence, 0, sample});
            return;
        }
        const auto open = std::find_if(sessions.rbegin(), sessions.rend(), [&](const SessionState& session) {
            return session.ended == 0 && session.session.station == sample.station;
        });
        if (open != sessions.rend()) {
            open->ended = m_event.sequence;
        } else {
            remark(m_state, m_event.sequence,
                   fmt::format("end of a session of \"{}\": expected its start before it", sample.station));
        }
    }

    // Only counted: the log has them.
    void handle(const CloudSample&) {}
    void handle(const RangesSample&) {}
    void handle(const JointSample&) {}
    void handle(const JointTrajectorySample&) {}
    void handle(const NumbersSample&) {}
    void handle(const PictureSample&) {}
    void handle(const CameraInfoSample&) {}
    void handle(const PongSample&) {}
    void handle(const TwistSample&) {}
    void handle(const ModeCommandSample&) {}
    void handle(const PoseSample&) {}
    void handle(const StreamCommandSample&) {}
    void handle(const PingSample&) {}
    void handle(const DriveLockSample&) {}
    void handle(const CheckpointSample&) {}

    MissionState& m_state;
    const Event& m_event;
};

/// Whether @p event comes after all of @p state. Robots share topics, so one message is an event of each
/// robot: the newest sequence may come again for another robot.
bool isNext(const MissionState& state, const Event& event) {
    if (event.sequence != state.sequence) return event.sequence > state.sequence;
    if (event.robot.empty()) return false;
    const auto robot = state.robots.find(event.robot);
    if (robot == state.robots.end()) return true;
    const auto& streams = robot->second->streams;
    const auto stream = streams.find(event.topic);
    return stream == streams.end() || stream->second.sequence < event.sequence;
}

}  // namespace

MissionState fold(MissionState state, const Event& event) {
    if (!isNext(state, event)) {
        remark(state, event.sequence,
               fmt::format("event {} of {}: expected a sequence above {}", event.sequence, event.topic,
                           state.sequence));
        return state;
    }
    Step(state, event).take();
    if (state.events++ == 0) state.first = event.received;
    state.last = event.received;
    state.sequence = event.sequence;
    return state;
}

void Fold::add(const Event& event) {
    m_state = fold(std::move(m_state), event);
}

std::optional<CheckpointSample> Fold::dueCheckpoint(Time now, std::chrono::nanoseconds interval) {
    if (m_state.sequence == m_checkpointedSequence || now - m_checkpointed < interval) return std::nullopt;
    m_checkpointed = now;
    m_checkpointedSequence = m_state.sequence;
    return checkpointOf(m_state, now);
}

MissionState stateAt(MissionHistory& history, std::uint64_t sequence) {
    Fold replay;
    for (auto stored = history.checkpointUpTo(sequence); stored;
         stored = stored->sequence > 1 ? history.checkpointUpTo(stored->sequence - 1) : std::nullopt) {
        auto state = stateOf(stored->checkpoint);
        // A checkpoint covers what came before it. An older one may be readable.
        if (!state || state->sequence >= stored->sequence) continue;
        replay = Fold(std::move(state).value());
        break;
    }
    history.events(replay.state().sequence, sequence, [&](const Event& event) { replay.add(event); });
    return replay.state();
}

}  // namespace leitstand
