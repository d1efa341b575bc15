#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/event/motion_samples.h"
#include "messages/std_msgs.h"
#include "messages/trajectory_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

/// A point has a number for each joint, or none.
void checkCount(const char* field, const std::vector<double>& numbers, std::size_t names, Checks& checks) {
    checks.require(numbers.empty() || numbers.size() == names, field, "expected {} or none, found {}", names,
                   numbers.size());
    for (const double value : numbers) checks.known(field, value);
}

void checkPoints(std::size_t points, Checks& checks) {
    checks.require(points <= JointTrajectorySample::MostPoints, "points", "expected at most {}, found {}",
                   JointTrajectorySample::MostPoints, points);
}

}  // namespace

JointTrajectorySample fromWire(const wire::trajectory_msgs::JointTrajectory& from, const Source&,
                               Checks& checks) {
    JointTrajectorySample to;
    to.header = checks.header(from.header);
    to.names = from.joint_names;
    checkPoints(from.points.size(), checks);
    if (!checks.ok()) return to;
    to.points.reserve(from.points.size());
    for (const auto& point : from.points) {
        checkCount("points.positions", point.positions, to.names.size(), checks);
        checkCount("points.velocities", point.velocities, to.names.size(), checks);
        to.points.push_back({point.positions, point.velocities,
                             checks.duration("points.time_from_start", point.time_from_start)});
    }
    return to;
}

void toWire(const JointTrajectorySample& from, wire::trajectory_msgs::JointTrajectory& to, Buffer&,
            Checks& checks) {
    to.header = checks.wireHeader(from.header);
    to.joint_names = from.names;
    checkPoints(from.points.size(), checks);
    to.points.reserve(from.points.size());
    for (const TrajectoryPoint& point : from.points) {
        checkCount("points.positions", point.positions, from.names.size(), checks);
        checkCount("points.velocities", point.velocities, from.names.size(), checks);
        to.points.push_back({point.positions,
                             point.velocities,
                             {},
                             {},
                             checks.wireDuration("points.time_from_start", point.fromStart)});
    }
}

NumbersSample fromWire(const wire::std_msgs::Float64MultiArray& from, const Source&, Checks& checks) {
    for (const double value : from.data) checks.known("data", value);
    return {from.data};
}

void toWire(const NumbersSample& from, wire::std_msgs::Float64MultiArray& to, Buffer&, Checks& checks) {
    for (const double value : from.values) checks.known("data", value);
    to.data = from.values;
}

std::vector<Conversion> jointConversions() {
    return {
        conversion<wire::trajectory_msgs::JointTrajectory, JointTrajectorySample>(),
        conversion<wire::std_msgs::Float64MultiArray, NumbersSample>(),
    };
}

}  // namespace leitstand::detail
