#include "tests/compat/state_text.h"

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/event/all_samples.h"
#include "core/event/candidate_sample.h"
#include "core/event/command_samples.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/sample_header.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/session_state.h"

namespace leitstand::test {
namespace {

/// Lines below a path; fields of a value are overloads of put().
class Lines {
public:
    Lines(std::vector<std::string>& lines, std::string path) : m_lines(lines), m_path(std::move(path)) {}

    template <class T>
    void operator()(const std::string& name, const T& value) const {
        const std::string path = m_path.empty() ? name : m_path + '.' + name;
        if constexpr (std::is_same_v<T, bool>) {
            m_lines.push_back(path + (value ? " = true" : " = false"));
        } else if constexpr (std::is_enum_v<T>) {
            m_lines.push_back(fmt::format("{} = {}", path, static_cast<int>(value)));
        } else if constexpr (std::is_integral_v<T>) {
            m_lines.push_back(fmt::format("{} = {}", path, value));
        } else if constexpr (std::is_floating_point_v<T>) {
            // Less than this is what computing left.
            m_lines.push_back(fmt::format("{} = {:.9g}", path, std::abs(value) < 1e-12 ? T(0) : value));
        } else if constexpr (std::is_convertible_v<T, std::string>) {
            m_lines.push_back(path + " = \"" + std::string(value) + '"');
        } else {
            put(Lines(m_lines, path), value);
        }
    }

private:
    std::vector<std::string>& m_lines;
    const std::string m_path;
};

void put(const Lines& to, const Time& time) {
    to("ns", static_cast<std::int64_t>(time.time_since_epoch().count()));
}
void put(const Lines& to, const std::chrono::nanoseconds& time) {
    to("ns", static_cast<std::int64_t>(time.count()));
}
void put(const Lines& to, const Eigen::Vector2d& value) {
    to("x", value.x()), to("y", value.y());
}
void put(const Lines& to, const Eigen::Vector3d& value) {
    to("x", value.x()), to("y", value.y()), to("z", value.z());
}
void put(const Lines& to, const Eigen::Quaterniond& value) {
    const double sign = value.w() < 0 ? -1.0 : 1.0;
    to("w", sign * value.w()), to("x", sign * value.x()), to("y", sign * value.y()),
        to("z", sign * value.z());
}
void put(const Lines& to, const Pose& value) {
    to("at", Eigen::Vector3d(value.translation()));
    to("turned", Eigen::Quaterniond(value.linear()));
}
template <class T>
void put(const Lines& to, const std::optional<T>& value) {
    if (value) to("is", *value);
}
template <class T>
void put(const Lines& to, const std::shared_ptr<const T>& value) {
    if (value) to("is", *value);
}
template <class T>
void put(const Lines& to, const std::vector<T>& values) {
    to("count", values.size());
    for (std::size_t i = 0; i < values.size(); ++i) to(std::to_string(i), values[i]);
}
void put(const Lines& to, const std::pair<std::string, std::string>& value) {
    to("key", value.first), to("value", value.second);
}
void put(const Lines& to, const SampleHeader& header) {
    to("stamp", header.stamp), to("frame", header.frame);
}

void put(const Lines& to, const VictimSign& sign) {
    to("state", sign.state), to("text", sign.text), to("value", sign.value);
}
void put(const Lines& to, const VictimEvidence& one) {
    to("kind", one.kind), to("topic", one.topic), to("sequence", one.sequence), to("stamp", one.stamp);
}
void put(const Lines& to, const FindSample& one) {
    to("stamp", one.stamp), to("station", one.station), to("kind", one.kind), to("number", one.number);
    to("status", one.status), to("found", one.found), to("robot", one.robot),
        to("autonomous", one.autonomous);
    to("scan", one.scan), to("positionInScan", one.positionInScan), to("positionInMap", one.positionInMap);
    to("deviation", one.deviation), to("form", one.form), to("motion", one.motion), to("heat", one.heat);
    to("sound", one.sound), to("co2", one.co2), to("situation", one.situation), to("tag", one.tag);
    to("area", one.area), to("text", one.text), to("evidence", one.evidence),
        to("mergedInto", one.mergedInto);
}
void put(const Lines& to, const NoteSample& note) {
    to("stamp", note.stamp), to("station", note.station), to("robot", note.robot), to("text", note.text);
}
void put(const Lines& to, const ScanPose& pose) {
    to("scan", pose.scan), to("scanInMap", pose.scanInMap), to("rms", pose.rms);
    to("inlierRatio", pose.inlierRatio), to("overlap", pose.overlap), to("certainty", pose.certainty);
    to("converged", pose.converged), to("trust", pose.trust), to("doubts", int(pose.doubts));
}
void put(const Lines& to, const ScanPosesSample& poses) {
    to("stamp", poses.stamp), to("station", poses.station), to("cause", poses.cause),
        to("poses", poses.poses);
}
void put(const Lines& to, const Link& link) {
    to("id", link.id), to("from", link.from), to("to", link.to), to("pose", link.pose), to("kind", link.kind),
        to("station", link.station), to("active", link.active);
    for (Eigen::Index i = 0; i < link.information.size(); ++i)
        to(fmt::format("information.{}", i), link.information.data()[i]);
}
void put(const Lines& to, const ScanLinksSample& links) {
    to("stamp", links.stamp), to("station", links.station), to("links", links.links);
}
void put(const Lines& to, const BodyInScan& body) {
    to("robot", body.robot), to("footprint", body.footprint), to("height", body.height),
        to("baseInScan", body.baseInScan), to("margin", body.margin);
}
void put(const Lines& to, const BodiesOfScan& bodies) {
    to("scan", bodies.scan), to("bodies", bodies.bodies);
}
void put(const Lines& to, const ScanBodiesSample& bodies) {
    to("stamp", bodies.stamp), to("station", bodies.station), to("scans", bodies.scans);
}
void put(const Lines& to, const KeyScanEntry& scan) {
    to("id", scan.id), to("robot", scan.robot), to("stamp", scan.stamp),
        to("sensorInBase", scan.sensorInBase);
    to("scanInMap", scan.scanInMap), to("sensorInOdom", scan.sensorInOdom), to("matched", scan.matched);
    to("points", scan.points);
}
void put(const Lines& to, const UndoSample& undo) {
    to("stamp", undo.stamp), to("station", undo.station), to("event", undo.event), to("text", undo.text);
}
void put(const Lines& to, const MapCropSample& crop) {
    to("stamp", crop.stamp), to("station", crop.station), to("polygon", crop.polygon),
        to("ceiling", crop.ceiling);
}
void put(const Lines& to, const Decision& decision) {
    to("sequence", decision.sequence), to("received", decision.received), to("undone", decision.undone);
    to("kind", decision.content.index());
    std::visit([&](const auto& content) { to("content", content); }, decision.content);
}
void put(const Lines& to, const FindState& one) {
    to("sequence", one.sequence), to("filed", one.filed), to("victim", one.victim);
}
void put(const Lines& to, const Cue& cue) {
    to("kind", cue.kind), to("robot", cue.robot), to("sensor", cue.sensor), to("topic", cue.topic);
    to("sequence", cue.sequence), to("stamp", cue.stamp), to("value", cue.value);
    to("confidence", cue.confidence), to("text", cue.text);
}
void put(const Lines& to, const CandidateSample& one) {
    to("stamp", one.stamp), to("station", one.station), to("id", one.id), to("kind", one.kind);
    to("scan", one.scan), to("positionInScan", one.positionInScan), to("positionInMap", one.positionInMap);
    to("deviation", one.deviation), to("confidence", one.confidence), to("victim", one.victim);
    to("dismissed", one.dismissed), to("cues", one.cues);
}
void put(const Lines& to, const CandidateState& one) {
    to("sequence", one.sequence), to("first", one.first), to("toldAt", one.firstReport.stamp);
    to("toldBy", one.firstReport.robot), to("toldAutonomous", one.firstReport.autonomous),
        to("candidate", one.candidate);
}
void put(const Lines& to, const KeyScanState& scan) {
    to("sequence", scan.sequence), to("entry", scan.entry), to("pose", scan.pose);
    to("poseSequence", scan.poseSequence);
}
void put(const Lines& to, const GrantState& grant) {
    to("station", grant.station), to("title", grant.title), to("term", grant.term);
    to("heartbeat", grant.heartbeat), to("requestedBy", grant.requestedBy);
}
void put(const Lines& to, const AlarmSample& alarm) {
    to("stamp", alarm.stamp), to("station", alarm.station), to("robot", alarm.robot), to("key", alarm.key);
    to("severity", alarm.severity), to("state", alarm.state), to("text", alarm.text);
}
void put(const Lines& to, const AlarmState& alarm) {
    to("sequence", alarm.sequence), to("raised", alarm.raised), to("times", alarm.times),
        to("alarm", alarm.alarm);
}
void put(const Lines& to, const SessionState& one) {
    to("started", one.started), to("ended", one.ended), to("stamp", one.session.stamp);
    to("station", one.session.station), to("title", one.session.title), to("start", one.session.start);
    to("mission", one.session.mission), to("version", one.session.version);
    to("operators", one.session.operators);
}
void put(const Lines& to, const ClockSample& clock) {
    to("stamp", clock.stamp), to("station", clock.station), to("running", clock.running);
    to("elapsed", clock.elapsed), to("limit", clock.limit);
}
void put(const Lines& to, const MissionInfoSample& info) {
    to("stamp", info.stamp), to("station", info.station), to("competition", info.competition);
    to("team", info.team), to("country", info.country), to("mission", info.mission);
    to("operators", info.operators), to("area", info.area), to("profile", info.profile);
}

void put(const Lines& to, const OdometrySample& one) {
    to("header", one.header), to("childFrame", one.childFrame), to("baseInOdom", one.baseInOdom);
    to("linear", one.linear), to("angular", one.angular);
}
void put(const Lines& to, const ImuSample& one) {
    to("header", one.header), to("orientation", one.orientation), to("angularVelocity", one.angularVelocity);
    to("linearAcceleration", one.linearAcceleration);
}
void put(const Lines& to, const ModeSample& one) {
    to("header", one.header), to("mode", one.mode), to("autonomous", one.autonomous),
        to("reason", one.reason);
    to("available", one.available);
}
void put(const Lines& to, const BatterySample& one) {
    to("header", one.header), to("voltage", one.voltage), to("current", one.current),
        to("charge", one.charge);
    to("capacity", one.capacity), to("fraction", one.fraction), to("temperature", one.temperature);
    to("status", one.status), to("present", one.present), to("location", one.location);
}
void put(const Lines& to, const GasSample& one) {
    to("header", one.header), to("gas", one.gas), to("ppm", one.ppm);
}
void put(const Lines& to, const Bumper& one) {
    to("name", one.name), to("pressed", one.pressed), to("hits", one.hits);
}
void put(const Lines& to, const BumpSample& one) {
    to("header", one.header), to("bumpers", one.bumpers);
}
void put(const Lines& to, const Sighting& one) {
    to("id", one.id), to("kind", one.kind), to("position", one.position), to("deviation", one.deviation);
    to("confidence", one.confidence), to("value", one.value), to("text", one.text);
}
void put(const Lines& to, const SightingSample& one) {
    to("header", one.header), to("sightings", one.sightings);
}
void put(const Lines& to, const DiagnosticStatus& one) {
    to("level", one.level), to("name", one.name), to("message", one.message),
        to("hardwareId", one.hardwareId);
    to("values", one.values);
}
void put(const Lines& to, const DiagnosticsSample& one) {
    to("header", one.header), to("statuses", one.statuses);
}
void put(const Lines& to, const StopStateSample& one) {
    to("header", one.header), to("number", one.number), to("station", one.station),
        to("stopped", one.stopped);
    to("standing", one.standing), to("refused", one.refused), to("stops", one.stops);
}
void put(const Lines& to, const StopCommandSample& one) {
    to("stamp", one.stamp), to("station", one.station), to("number", one.number), to("stop", one.stop);
    to("releases", one.releases);
}
void put(const Lines& to, const ClockOffsetSample& one) {
    to("stamp", one.stamp), to("robot", one.robot), to("ahead", one.ahead);
    to("uncertainty", one.uncertainty), to("roundTrip", one.roundTrip);
}
void put(const Lines& to, const RobotPlaceSample& one) {
    to("stamp", one.stamp), to("station", one.station), to("robot", one.robot), to("cause", one.cause);
    to("measured", one.measured), to("baseInMap", one.baseInMap), to("odomInMap", one.odomInMap);
    to("certainty", one.certainty), to("overlap", one.overlap), to("certain", one.certain),
        to("how", one.how);
}
template <class T>
void put(const Lines& to, const Latest<T>& latest) {
    to("sequence", latest.sequence), to("received", latest.received), to("sample", latest.sample);
}
void put(const Lines& to, const CropState& crop) {
    to("sequence", crop.sequence), to("received", crop.received), to("sample", crop.sample);
}
void put(const Lines& to, const Contact& one) {
    to("sequence", one.sequence), to("received", one.received), to("bumper", one.bumper),
        to("hits", one.hits);
    to("baseInOdom", one.baseInOdom);
}
void put(const Lines& to, const StreamState& one) {
    to("role", one.role ? toString(*one.role) : std::string()), to("sensor", one.sensor);
    to("events", one.events), to("sequence", one.sequence), to("received", one.received),
        to("stamp", one.stamp);
}
void put(const Lines& to, const std::map<std::string, StreamState>& streams) {
    for (const auto& [topic, stream] : streams) to(topic, stream);
}
void put(const Lines& to, const RobotState& robot) {
    to("odometry", robot.odometry), to("imu", robot.imu), to("mode", robot.mode),
        to("battery", robot.battery);
    to("load.current", robot.load.current), to("load.seconds", robot.load.seconds), to("gas", robot.gas);
    to("bumps", robot.bumps), to("contacts", robot.contacts), to("sightings", robot.sightings);
    to("diagnostics", robot.diagnostics), to("stop", robot.stop), to("stopCommand", robot.stopCommand);
    to("clockOffset", robot.clockOffset), to("place", robot.place), to("streams", robot.streams);
}

}  // namespace

std::vector<std::string> stateText(const MissionState& state) {
    std::vector<std::string> lines;
    const Lines to(lines, {});
    to("sequence", state.sequence), to("events", state.events), to("first", state.first),
        to("last", state.last);
    for (const auto& [name, robot] : state.robots) to("robots." + name, *robot);
    to("ownTopics", *state.ownTopics);
    to("decisions", *state.decisions);
    for (const auto& [key, find] : *state.finds) to("finds." + nameOf(key.first, key.second), find);
    for (const auto& [id, candidate] : *state.candidates) to(fmt::format("candidates.{}", id), candidate);
    for (const auto& [id, scan] : *state.keyScans) to(fmt::format("keyScans.{}", id), scan);
    to("notes", *state.notes), to("crop", state.crop);
    for (const auto& [key, grant] : *state.grants)
        to(fmt::format("grants.{}.{}", static_cast<int>(key.first), key.second), grant);
    for (const auto& [key, alarm] : *state.alarms)
        to("alarms." + std::get<0>(key) + '.' + std::get<1>(key) + '.' + std::get<2>(key), alarm);
    to("sessions", *state.sessions);
    for (const FoldRemark& remark : *state.remarks) to("remarks", remark.sequence);
    to("clock", state.clock), to("info", state.info);
    return lines;
}

}  // namespace leitstand::test
