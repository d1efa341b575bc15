#include "transport/services/navigation_messages.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "core/event/stream_role.h"
#include "messages/geometry_msgs.h"
#include "transport/cdr/cdr_reader.h"
#include "transport/cdr/cdr_writer.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"
#include "transport/services/goal_info.h"

namespace leitstand {
namespace {

constexpr const char* PoseType = "geometry_msgs/msg/PoseStamped";
constexpr double Nano = 1e-9;

/// action_msgs/msg/GoalStatus.
struct GoalStatus {
    static constexpr std::size_t LeastSize = GoalInfo::LeastSize + 1;
    GoalInfo info;
    std::int8_t status = 0;
};
void decode(CdrReader& in, GoalStatus& to) {
    in.read("goal_info", to.info);
    in.read("status", to.status);
}
void encode(CdrWriter& out, const GoalStatus& from) {
    out.write(from.info);
    out.write(from.status);
}

Payload payloadOf(CdrWriter&& out) {
    return std::make_shared<const std::vector<std::byte>>(std::move(out).finish());
}

void readDuration(CdrReader& in, const char* field, double& seconds) {
    std::int32_t whole = 0;
    std::uint32_t rest = 0;
    in.read(field, whole);
    in.read(field, rest);
    seconds = static_cast<double>(whole) + Nano * static_cast<double>(rest);
}

void writeDuration(CdrWriter& out, double seconds) {
    const double whole = std::floor(seconds);
    out.write(static_cast<std::int32_t>(whole));
    out.write(static_cast<std::uint32_t>((seconds - whole) / Nano));
}

GoalTracker::Status statusOf(std::int8_t number) {
    const bool known = number >= 0 && number <= static_cast<std::int8_t>(GoalTracker::Status::Aborted);
    return known ? static_cast<GoalTracker::Status>(number) : GoalTracker::Status::Unknown;
}

}  // namespace

ActionNames actionNames(const std::string& name, const std::string& type) {
    const std::string below = name + "/_action/";
    return {below + "send_goal", below + "cancel_goal", below + "feedback",
            below + "status",    type + "_SendGoal",    type + "_FeedbackMessage"};
}

Result<Payload> encodeGoal(const NavigationGoal& goal) {
    const auto pose = encode(goal.goal, PoseType);
    if (!pose) return pose.error();
    CdrReader in(**pose);
    wire::geometry_msgs::PoseStamped stamped;
    in.read("pose", stamped);
    CdrWriter out;
    out.write(goal.id);
    out.write(stamped);
    out.write(std::string());  // behavior_tree
    return payloadOf(std::move(out));
}

Result<NavigationGoal> decodeGoal(std::span<const std::byte> bytes) {
    CdrReader in(bytes);
    NavigationGoal goal;
    wire::geometry_msgs::PoseStamped stamped;
    std::string tree;
    in.read("goal_id", goal.id);
    in.read("pose", stamped);
    in.read("behavior_tree", tree);
    if (auto done = in.finish(); !done) return done.error();
    CdrWriter out;
    out.write(stamped);
    RawEvent event;
    event.type = PoseType;
    event.cdr = payloadOf(std::move(out));
    StreamDescription stream;
    stream.role = StreamRole::GoalPose;
    stream.type = PoseType;
    const auto pose = decode(event, stream);
    if (!pose) return pose.error();
    goal.goal = pose->get<PoseSample>();
    return goal;
}

Payload encodeAcceptance(bool accepted) {
    CdrWriter out;
    out.write(accepted);
    out.write(std::int32_t{0});  // when it was accepted
    out.write(std::uint32_t{0});
    return payloadOf(std::move(out));
}

Result<bool> decodeAcceptance(std::span<const std::byte> bytes) {
    CdrReader in(bytes);
    bool accepted = false;
    std::int32_t seconds = 0;
    std::uint32_t nanoseconds = 0;
    in.read("accepted", accepted);
    in.read("sec", seconds);
    in.read("nanosec", nanoseconds);
    if (auto done = in.finish(); !done) return done.error();
    return accepted;
}

Payload encodeCancel(const GoalId& goal) {
    CdrWriter out;
    out.write(GoalInfo{goal, 0, 0});
    return payloadOf(std::move(out));
}

Result<GoalId> decodeCancel(std::span<const std::byte> bytes) {
    CdrReader in(bytes);
    GoalInfo goal;
    in.read("goal_info", goal);
    if (auto done = in.finish(); !done) return done.error();
    return goal.id;
}

Payload encodeProgress(const NavigationProgress& progress) {
    CdrWriter out;
    out.write(progress.id);
    out.write(wire::geometry_msgs::PoseStamped{});  // where it is; odometry says that, too
    writeDuration(out, 0.0);
    writeDuration(out, progress.seconds);
    out.write(static_cast<std::int16_t>(progress.recoveries));
    out.write(static_cast<float>(progress.metres));
    return payloadOf(std::move(out));
}

Result<NavigationProgress> decodeProgress(std::span<const std::byte> bytes) {
    CdrReader in(bytes);
    NavigationProgress progress;
    wire::geometry_msgs::PoseStamped here;
    double driven = 0.0;
    std::int16_t recoveries = 0;
    float metres = 0.0F;
    in.read("goal_id", progress.id);
    in.read("current_pose", here);
    readDuration(in, "navigation_time", driven);
    readDuration(in, "estimated_time_remaining", progress.seconds);
    in.read("number_of_recoveries", recoveries);
    in.read("distance_remaining", metres);
    if (auto done = in.finish(); !done) return done.error();
    progress.recoveries = recoveries;
    progress.metres = static_cast<double>(metres);
    return progress;
}

Payload encodeStatus(std::span<const GoalTracker::Report> goals) {
    std::vector<GoalStatus> all;
    all.reserve(goals.size());
    for (const GoalTracker::Report& goal : goals)
        all.push_back({{goal.goal, 0, 0}, static_cast<std::int8_t>(goal.status)});
    CdrWriter out;
    out.write(all);
    return payloadOf(std::move(out));
}

Result<std::vector<GoalTracker::Report>> decodeStatus(std::span<const std::byte> bytes) {
    CdrReader in(bytes);
    std::vector<GoalStatus> all;
    in.read("status_list", all);
    if (auto done = in.finish(); !done) return done.error();
    std::vector<GoalTracker::Report> goals;
    goals.reserve(all.size());
    for (const GoalStatus& one : all) goals.push_back({one.info.id, statusOf(one.status)});
    return goals;
}

}  // namespace leitstand
