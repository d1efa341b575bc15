#include "app/services/comparison/recorded_truth.h"

#include <algorithm>

#include "core/event/motion_samples.h"
#include "core/event/raw_event.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/raw_events.h"
#include "core/robot/robot_description.h"
#include "transport/convert/decode.h"

namespace leitstand {
namespace {

constexpr std::string_view Root = "/truth/", Leaf = "/ground_truth";
constexpr std::string_view Odometry = "nav_msgs/msg/Odometry", Sightings = "leitstand_msgs/msg/Sightings";

/// Returns the robot that @p pose on @p topic belongs to; empty: unknown.
std::string robotOf(const std::string& topic, const OdometrySample& pose) {
    const auto slash = pose.childFrame.find('/');
    if (slash != std::string::npos && slash > 0) return pose.childFrame.substr(0, slash);
    if (!topic.ends_with(Leaf) || topic.size() <= Leaf.size() + 1) return {};
    return topic.substr(1, topic.size() - Leaf.size() - 1);
}

}  // namespace

RecordedTruth readTruth(BagReader& bag, const Progress& progress) {
    RecordedTruth truth;
    BagQuery query;
    for (const BagTopic& topic : bag.topics()) {
        const bool ours = topic.info.name.starts_with(Root);
        const bool pose = topic.info.type == Odometry && (ours || topic.info.name.ends_with(Leaf));
        const bool victims = ours && topic.info.type == Sightings && topic.info.name.ends_with("/victims");
        if (pose || victims) query.topics.push_back(topic.info.name);
    }
    if (query.topics.empty()) return truth;
    const auto take = [&truth](const RawEvent& raw) {
        StreamDescription stream;
        stream.role = raw.type == Odometry ? StreamRole::Odometry : StreamRole::Sightings;
        stream.topic = raw.topic;
        stream.type = raw.type;
        const auto sample = decode(raw, stream);
        if (!sample) return true;
        if (const auto* pose = sample->as<OdometrySample>()) {
            const std::string robot = robotOf(raw.topic, *pose);
            if (robot.empty() || !pose->baseInOdom.matrix().allFinite()) return true;
            const Time at = pose->header.stamp == Time{} ? raw.received : pose->header.stamp;
            truth.robots[robot].push_back({at, pose->baseInOdom});
        } else if (const auto* all = sample->as<SightingSample>()) {
            truth.victims.clear();  // a sample always holds all of them
            for (const Sighting& one : all->sightings) {
                if (one.position.allFinite()) truth.victims.push_back(one.position);
            }
        }
        return true;
    };
    forEachRaw(bag, query, take, progress);
    for (auto& [robot, poses] : truth.robots) {
        std::stable_sort(poses.begin(), poses.end(),
                         [](const StampedPose& a, const StampedPose& b) { return a.at < b.at; });
    }
    return truth;
}

}  // namespace leitstand
