#pragma once

// The fields of a checkpoint, in the order of its bytes. A change here needs a new CheckpointVersion; a new
// field is described by since<N>(a, v.field), so that older checkpoints are read.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/event/all_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/markers/marker_board.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/session_state.h"

namespace leitstand {

/// Reads or writes @p fields, which exist only in checkpoints of version @p Version and later.
template <std::uint32_t Version, class A, class... T>
void since(A& a, T&... fields) {
    static_assert(Version <= CheckpointVersion, "a new field raises CheckpointVersion (checkpoint.h)");
    if (a.version() >= Version) a(fields...);
}

inline StreamRole lastOf(StreamRole) {
    return allStreamRoles().back();
}
inline BatterySample::Status lastOf(BatterySample::Status) {
    return BatterySample::Status::Full;
}
inline DiagnosticStatus::Level lastOf(DiagnosticStatus::Level) {
    return DiagnosticStatus::Level::Stale;
}
inline MarkerShape lastOf(MarkerShape) {
    return MarkerShape::Triangles;
}
inline GrantSample::Kind lastOf(GrantSample::Kind) {
    return GrantSample::Kind::Map;
}
inline AlarmSample::Severity lastOf(AlarmSample::Severity) {
    return AlarmSample::Severity::Critical;
}
inline AlarmSample::State lastOf(AlarmSample::State) {
    return AlarmSample::State::Cleared;
}
inline VictimSign::State lastOf(VictimSign::State) {
    return VictimSign::State::Present;
}
inline FindSample::Kind lastOf(FindSample::Kind) {
    return FindSample::Kind::Object;
}
inline FindSample::Status lastOf(FindSample::Status) {
    return FindSample::Status::Discarded;
}
inline ScanTrust lastOf(ScanTrust) {
    return ScanTrust::SetAside;
}
inline ScanPosesSample::Cause lastOf(ScanPosesSample::Cause) {
    return ScanPosesSample::Cause::Operator;
}
inline LinkKind lastOf(LinkKind) {
    return LinkKind::Geo;
}
inline RobotPlaceSample::Cause lastOf(RobotPlaceSample::Cause) {
    return RobotPlaceSample::Cause::Seen;
}

template <class A>
void describe(A& a, SampleHeader& v) {
    a(v.stamp, v.frame);
}
template <class A, class T>
void describe(A& a, Latest<T>& v) {
    a(v.sequence, v.received, v.sample);
}
template <class A>
void describe(A& a, StreamState& v) {
    a(v.role, v.sensor, v.events, v.sequence, v.received, v.stamp);
}
template <class A>
void describe(A& a, OdometrySample& v) {
    a(v.header, v.childFrame, v.baseInOdom, v.linear, v.angular);
}
template <class A>
void describe(A& a, ImuSample& v) {
    a(v.header, v.orientation, v.angularVelocity, v.linearAcceleration);
}
template <class A>
void describe(A& a, ModeSample& v) {
    a(v.header, v.mode, v.autonomous, v.reason, v.available);
}
template <class A>
void describe(A& a, BatterySample& v) {
    a(v.header, v.voltage, v.current, v.charge, v.capacity, v.fraction, v.temperature, v.status, v.present,
      v.location);
}
template <class A>
void describe(A& a, GasSample& v) {
    a(v.header, v.gas, v.ppm);
}
template <class A>
void describe(A& a, ReadingSample& v) {
    a(v.header, v.values);
}
template <class A>
void describe(A& a, RobotModelSample& v) {
    a(v.urdf);
}
template <class A>
void describe(A& a, Detection& v) {
    a(v.centre, v.size, v.turned, v.label, v.score);
}
template <class A>
void describe(A& a, DetectionsSample& v) {
    a(v.header, v.detections);
}
template <class A>
void describe(A& a, MarkerColour& v) {
    a(v.r, v.g, v.b, v.a);
}
template <class A>
void describe(A& a, Marker& v) {
    a(v.header, v.space, v.id, v.removed, v.shape, v.markerInFrame, v.size, v.colour, v.frameLocked,
      v.lifetime, v.points, v.text);
    if constexpr (!A::Writes) {
        if (!isDrawable(v)) a.fail();
    }
}
template <class A>
void describe(A& a, MarkerBoard::Drawn& v) {
    a(v.received, v.baseInOdom, v.marker);
    if constexpr (!A::Writes) {
        if (!v.marker) a.fail();
    }
}
template <class A>
void describe(A& a, MarkerBoard& v) {
    a(v.drawn);
    if constexpr (!A::Writes) {
        if (!isBounded(v)) a.fail();
    }
}
template <class A>
void describe(A& a, Bumper& v) {
    a(v.name, v.pressed, v.hits);
}
template <class A>
void describe(A& a, BumpSample& v) {
    a(v.header, v.bumpers);
}
template <class A>
void describe(A& a, Sighting& v) {
    a(v.id, v.kind, v.position, v.deviation, v.confidence, v.value, v.text);
}
template <class A>
void describe(A& a, SightingSample& v) {
    a(v.header, v.sightings);
}
template <class A>
void describe(A& a, DiagnosticStatus& v) {
    a(v.level, v.name, v.message, v.hardwareId, v.values);
}
template <class A>
void describe(A& a, DiagnosticsSample& v) {
    a(v.header, v.statuses);
}
template <class A>
void describe(A& a, StopStateSample& v) {
    a(v.header, v.number, v.station, v.stops, v.stopped, v.standing, v.refused);
}
template <class A>
void describe(A& a, StopCommandSample& v) {
    a(v.stamp, v.station, v.number, v.stop, v.releases);
}
template <class A>
void describe(A& a, ClockOffsetSample& v) {
    a(v.stamp, v.robot, v.ahead, v.uncertainty, v.roundTrip);
}
template <class A>
void describe(A& a, RobotPlaceSample& v) {
    a(v.stamp, v.station, v.robot, v.cause, v.measured, v.baseInMap, v.odomInMap, v.certainty, v.overlap,
      v.certain, v.how);
}
template <class A>
void describe(A& a, Contact& v) {
    a(v.sequence, v.received, v.bumper, v.hits, v.baseInOdom);
}
template <class A>
void describe(A& a, BatteryLoad& v) {
    a(v.current, v.seconds);
}
/// Cells as runs of equal ones, of which maps are made: the value and how often it comes, 3 bytes each.
[[nodiscard]] std::string runsOf(const std::vector<std::int8_t>& cells);
/// Returns @p count cells from @p runs; empty: these are no runs of so many cells.
[[nodiscard]] std::optional<std::vector<std::int8_t>> cellsOf(const std::string& runs, std::size_t count);

template <class A>
void describe(A& a, OccupancyGridSample& v) {
    std::string runs;
    if constexpr (A::Writes) runs = runsOf(v.cells);
    a(v.header, v.loaded, v.resolution, v.width, v.height, v.gridInFrame, runs);
    if constexpr (!A::Writes) {
        constexpr auto Most = OccupancyGridSample::MostCells;
        const bool sane = v.width >= 0 && v.height >= 0 && std::size_t(v.width) <= Most &&
                          std::size_t(v.height) <= Most &&
                          std::size_t(v.width) * std::size_t(v.height) <= Most;
        if (!sane || !a.mayUnpack(std::size_t(v.width) * std::size_t(v.height))) return a.fail();
        auto cells = cellsOf(runs, std::size_t(v.width) * std::size_t(v.height));
        if (!cells) return a.fail();
        v.cells = std::move(*cells);
    }
}
template <class A>
void describe(A& a, PathSample& v) {
    a(v.header, v.posesInFrame);
}
template <class A>
void describe(A& a, FrameInParent& v) {
    a(v.parent, v.inParent);
}
template <class A>
void describe(A& a, RobotState& v) {
    a(v.odometry, v.imu, v.mode, v.battery, v.load, v.gas, v.bumps, v.contacts, v.sightings, v.diagnostics,
      v.stop, v.stopCommand, v.clockOffset, v.place, v.streams);
    since<9>(a, v.framesAbove, v.grids, v.paths);
    since<10>(a, v.readings, v.markers);
    since<11>(a, v.model, v.detections);
    if constexpr (!A::Writes) {
        const auto isThere = [](const auto& one) { return one.second != nullptr; };
        if (!std::all_of(v.grids.begin(), v.grids.end(), isThere) ||
            !std::all_of(v.paths.begin(), v.paths.end(), isThere) ||
            !std::all_of(v.readings.begin(), v.readings.end(), isThere) ||
            !std::all_of(v.markers.begin(), v.markers.end(), isThere) ||
            !std::all_of(v.detections.begin(), v.detections.end(), isThere))
            a.fail();
    }
}
template <class A>
void describe(A& a, VictimSign& v) {
    a(v.state, v.text, v.value);
}
template <class A>
void describe(A& a, VictimEvidence& v) {
    a(v.kind, v.topic, v.sequence, v.stamp);
}
template <class A>
void describe(A& a, FindSample& v) {
    a(v.stamp, v.station, v.number, v.status, v.found, v.robot, v.autonomous, v.scan, v.positionInScan,
      v.positionInMap, v.deviation, v.form, v.motion, v.heat, v.sound, v.co2, v.situation, v.tag, v.area,
      v.text, v.evidence, v.kind, v.mergedInto);
}
template <class A>
void describe(A& a, Cue& v) {
    a(v.kind, v.robot, v.sensor, v.topic, v.sequence, v.stamp, v.value, v.confidence, v.text);
}
template <class A>
void describe(A& a, CandidateSample& v) {
    a(v.stamp, v.station, v.id, v.kind, v.scan, v.positionInScan, v.positionInMap, v.deviation, v.confidence,
      v.victim, v.dismissed, v.cues);
}
template <class A>
void describe(A& a, FirstReport& v) {
    a(v.stamp, v.robot, v.autonomous);
}
template <class A>
void describe(A& a, CandidateState& v) {
    a(v.sequence, v.first, v.firstReport, v.candidate);
}
template <class A>
void describe(A& a, MissionInfoSample& v) {
    a(v.stamp, v.station, v.competition, v.team, v.country, v.mission, v.operators, v.area, v.profile);
}
template <class A>
void describe(A& a, NoteSample& v) {
    a(v.stamp, v.station, v.robot, v.text);
}
template <class A>
void describe(A& a, ScanPose& v) {
    a(v.scan, v.scanInMap, v.rms, v.inlierRatio, v.overlap, v.certainty, v.converged, v.trust, v.doubts);
}
template <class A>
void describe(A& a, Link& v) {
    a(v.id, v.from, v.to, v.pose, v.information, v.kind, v.station, v.active);
}
template <class A>
void describe(A& a, ScanLinksSample& v) {
    a(v.stamp, v.station, v.links);
}
template <class A>
void describe(A& a, ScanPosesSample& v) {
    a(v.stamp, v.station, v.cause, v.poses);
}
template <class A>
void describe(A& a, MapCropSample& v) {
    a(v.stamp, v.station, v.polygon, v.ceiling);
}
template <class A>
void describe(A& a, BodyInScan& v) {
    a(v.robot, v.footprint, v.height, v.baseInScan, v.margin);
}
template <class A>
void describe(A& a, BodiesOfScan& v) {
    a(v.scan, v.bodies);
}
template <class A>
void describe(A& a, ScanBodiesSample& v) {
    a(v.stamp, v.station, v.scans);
}
template <class A>
void describe(A& a, KeyScanEntry& v) {
    a(v.id, v.robot, v.stamp, v.sensorInBase, v.scanInMap, v.sensorInOdom, v.matched, v.points);
}
template <class A>
void describe(A& a, UndoSample& v) {
    a(v.stamp, v.station, v.event, v.text);
}
template <class A>
void describe(A& a, Decision& v) {
    a(v.sequence, v.received, v.content);  // what is undone follows from the decisions
}
template <class A>
void describe(A& a, GrantState& v) {
    a(v.station, v.title, v.term, v.heartbeat, v.requestedBy);
}
template <class A>
void describe(A& a, AlarmSample& v) {
    a(v.stamp, v.station, v.robot, v.key, v.severity, v.state, v.text);
}
template <class A>
void describe(A& a, AlarmState& v) {
    a(v.sequence, v.raised, v.times, v.alarm);
}
template <class A>
void describe(A& a, SessionSample& v) {
    a(v.stamp, v.station, v.title, v.start, v.mission, v.version, v.operators);
}
template <class A>
void describe(A& a, SessionState& v) {
    a(v.started, v.ended, v.session);
}
template <class A>
void describe(A& a, FoldRemark& v) {
    a(v.sequence, v.text);
}
template <class A>
void describe(A& a, ClockSample& v) {
    a(v.stamp, v.station, v.running, v.elapsed, v.limit);
}
template <class A, class T>
void describe(A& a, SharedValue<T>& v) {
    if constexpr (A::Writes) {
        a(const_cast<T&>(*v));  // a writing archive changes nothing; edit() would copy
    } else {
        a(v.edit());
    }
}
template <class A>
void describe(A& a, MissionState& v) {
    // Victims, key scans, loops, bodies of robots in scans, notes and the area of the map follow from the
    // decisions.
    a(v.sequence, v.events, v.first, v.last, v.robots, v.ownTopics, v.decisions, v.grants, v.alarms,
      v.sessions, v.remarks, v.clock, v.candidates, v.info);
}

}  // namespace leitstand
