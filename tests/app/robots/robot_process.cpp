#include "tests/app/robots/robot_process.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/services/offline/mission_scans.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "tests/app/recording.h"

namespace leitstand::test {
namespace {

StreamDescription reported(StreamRole role, const std::string& topic, const std::string& type,
                           const Qos& qos) {
    StreamDescription stream;
    stream.role = role;
    stream.topic = topic;
    stream.type = type;
    stream.qos = qos;
    return stream;
}

/// Of TF "kurt3d/base_link".
bool isOf(const OdometrySample& pose, const std::string& name) {
    return pose.childFrame == name + "/base_link";
}

Pose poseOf(const nlohmann::json& scan) {
    const auto numbers = scan["pose"].get<std::vector<double>>();
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = numbers[static_cast<std::size_t>(i)];
    return Pose(matrix);
}

/// Whether the end of the recording cut the last of @p scans off: it sees too little to be held against the
/// truth.
bool lastIsCutOff(const std::vector<ScanPtr>& scans) {
    std::size_t most = 0;
    for (const ScanPtr& scan : scans) most = std::max(most, scan->points.size());
    return !scans.empty() && scans.back()->points.size() < most - most / 50;
}

}  // namespace

Truth::Truth(const TestDomain& domain, const std::string& arena, const std::string& robot) : m_arena(arena) {
    NodeSettings settings;
    settings.domain = domain.number() + TruthAbove;
    settings.name = "truth listener";
    m_node = must(Node::create(settings));
    const Qos lasting = transientLocal(10);
    std::vector<StreamDescription> streams = {
        reported(StreamRole::Odometry, topic("kurt3d"), "nav_msgs/msg/Odometry", bestEffort(50)),
        reported(StreamRole::Odometry, topic("crawler"), "nav_msgs/msg/Odometry", bestEffort(50)),
        reported(StreamRole::Sightings, topic("victims"), "leitstand_msgs/msg/Sightings", lasting),
        reported(StreamRole::Bumps, topic("contacts"), "leitstand_msgs/msg/Bumps", lasting),
    };
    if (!robot.empty())
        streams.push_back(
            reported(StreamRole::Picture, topic(robot + "/labels"), "sensor_msgs/msg/Image", reliable(100)));
    m_listener = std::make_unique<RobotListener>(*m_node, streams);
}

std::optional<Pose> Truth::baseInArena(const std::string& kind, const std::string& name, Time at) const {
    std::optional<OdometrySample> before;
    for (const OdometrySample& pose : m_listener->all<OdometrySample>(topic(kind))) {
        if (!isOf(pose, name)) continue;
        if (pose.header.stamp < at) {
            before = pose;
            continue;
        }
        if (!before) return std::nullopt;
        const double share = std::chrono::duration<double>(at - before->header.stamp) /
                             (pose.header.stamp - before->header.stamp);
        return interpolated(before->baseInOdom, pose.baseInOdom, share);
    }
    return std::nullopt;
}

std::optional<OdometrySample> Truth::newest(const std::string& kind, const std::string& name) const {
    std::optional<OdometrySample> last;
    for (const OdometrySample& pose : m_listener->all<OdometrySample>(topic(kind))) {
        if (isOf(pose, name)) last = pose;
    }
    return last;
}

std::string hallFile(const std::string& name) {
    return "name: " + name + R"(
from: [-2.5, -2]
to: [2.5, 2]
starts:
  kurt3d: {position: [-0.8, 0, 0]}
  crawler: {position: [0.8, 0, 0], turn: [0, 0, 180]}
elements:
  - {kind: floor, position: [0, 0, 0], size: [5, 4, 0.1]}
  - {kind: wall, name: north, position: [0, 2, 0], size: [5, 0.05, 1.2]}
  - {kind: wall, name: south, position: [0, -2, 0], size: [5, 0.05, 1.2]}
  - {kind: wall, name: east, position: [2.5, 0, 0], turn: [0, 0, 90], size: [4, 0.05, 1.2]}
  - {kind: wall, name: west, position: [-2.5, 0, 0], turn: [0, 0, 90], size: [4, 0.05, 1.2]}
  - {kind: ceiling, position: [-1.8, 0, 1.1], size: [1.2, 3.9, 0.02]}
  - {kind: victim, name: in the corner, position: [1.2, 1.6, 0], victim: {tag: V-01, temperature: 35}}
)";
}

Registered registerAgainst(const Truth& truth, const std::filesystem::path& mission,
                           const RobotDescription& robot, const std::vector<std::string>& more) {
    Registered result;
    std::vector<std::string> arguments = {"register", mission.string(), "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto run = leitstandctl(arguments);
    const auto read = readMissionScans(mission);
    if (run.exitCode != 0 || !read) {
        result.problems.push_back(run.err + (read ? "" : read.error().text));
        return result;
    }
    const auto registered = nlohmann::json::parse(run.out)["scans"];
    if (registered.size() != read->scans.size()) {
        result.problems.push_back(
            fmt::format("{} scans, {} registered", read->scans.size(), registered.size()));
        return result;
    }
    const Pose laserInBase = robot.sensors.at(robot.mappingStream()->sensor).sensorInBase;
    std::optional<Pose> first;
    const std::size_t whole = registered.size() - (lastIsCutOff(read->scans) ? 1 : 0);
    for (std::size_t i = 0; i < whole; ++i) {
        const auto base = truth.baseInArena("kurt3d", robot.name, read->scans[i]->end);
        if (!base) {
            // Scans before the first that the truth's listener heard of are left out.
            if (first) result.problems.push_back(read->scans[i]->name + ": nobody told where it was taken");
            continue;
        }
        ++result.scans;
        const Pose laserInArena = *base * laserInBase;
        if (!first) first = laserInArena * poseOf(registered[i]).inverse();
        const Pose laserInMap = first->inverse() * laserInArena, found = poseOf(registered[i]);
        result.travelled = std::max(result.travelled, laserInMap.translation().norm());
        result.worstPosition =
            std::max(result.worstPosition, (laserInMap.translation() - found.translation()).norm());
        result.worstTurn = std::max(result.worstTurn, angleBetween(laserInMap, found));
    }
    return result;
}

}  // namespace leitstand::test
