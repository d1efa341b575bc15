#include "transport/convert/detail/checks.h"

#include <limits>

namespace leitstand::detail {
namespace {

using std::chrono::nanoseconds;
using std::chrono::seconds;
constexpr std::uint32_t NanosecondsOfSecond = 1'000'000'000;

}  // namespace

void Checks::fail(const char* field, const std::string& text) {
    if (ok()) m_error = fmt::format("{}: {}", field, text);
}

int Checks::size(const char* field, std::uint32_t value, int most) {
    require(value <= static_cast<std::uint32_t>(most), field, "expected at most {}, found {}", most, value);
    return ok() ? static_cast<int>(value) : 0;
}

Time Checks::time(const char* field, const wire::builtin_interfaces::Time& from) {
    require(from.sec >= 0 && from.nanosec < NanosecondsOfSecond, field,
            "expected a time after 1970 with less than 1e9 ns, found {} s {} ns", from.sec, from.nanosec);
    return Time(seconds(from.sec) + nanoseconds(from.nanosec));
}

nanoseconds Checks::duration(const char* field, const wire::builtin_interfaces::Duration& from) {
    require(from.nanosec < NanosecondsOfSecond, field, "expected less than 1e9 ns, found {}", from.nanosec);
    return seconds(from.sec) + nanoseconds(from.nanosec);
}

SampleHeader Checks::header(const wire::std_msgs::Header& from) {
    return {time("header.stamp", from.stamp), from.frame_id};
}

Eigen::Quaterniond Checks::rotation(const char* field, const wire::geometry_msgs::Quaternion& from) {
    const Eigen::Quaterniond quaternion(finite(field, from.w), finite(field, from.x), finite(field, from.y),
                                        finite(field, from.z));
    const double norm = quaternion.norm();
    require(norm > 0.9 && norm < 1.1, field, "expected a quaternion of length 1, found {}", norm);
    return ok() ? quaternion.normalized() : Eigen::Quaterniond::Identity();
}

Pose Checks::pose(const char* field, const wire::geometry_msgs::Pose& from) {
    Pose pose = Pose::Identity();
    pose.linear() = rotation(field, from.orientation).toRotationMatrix();
    pose.translation() = vector(field, from.position);
    return pose;
}

wire::builtin_interfaces::Time Checks::wireTime(const char* field, Time from) {
    const auto whole = std::chrono::floor<seconds>(from);
    const auto count = whole.time_since_epoch().count();
    require(count >= 0 && count <= std::numeric_limits<std::int32_t>::max(), field,
            "expected a time between 1970 and 2038, found {} s", count);
    return {static_cast<std::int32_t>(count), static_cast<std::uint32_t>((from - whole).count())};
}

wire::builtin_interfaces::Duration Checks::wireDuration(const char* field, nanoseconds from) {
    const auto whole = std::chrono::floor<seconds>(from);
    require(std::abs(whole.count()) <= std::numeric_limits<std::int32_t>::max(), field,
            "expected less than 68 years, found {} s", whole.count());
    return {static_cast<std::int32_t>(whole.count()), static_cast<std::uint32_t>((from - whole).count())};
}

wire::std_msgs::Header Checks::wireHeader(const SampleHeader& from) {
    return {wireTime("header.stamp", from.stamp), from.frame};
}

wire::geometry_msgs::Quaternion Checks::wireRotation(const char* field, const Eigen::Quaterniond& from) {
    require(std::abs(from.norm() - 1.0) < 1e-3, field, "expected a rotation, its quaternion has length {}",
            from.norm());
    return {from.x(), from.y(), from.z(), from.w()};
}

wire::geometry_msgs::Pose Checks::wirePose(const char* field, const Pose& from) {
    return {wireVector<wire::geometry_msgs::Point>(field, from.translation()),
            wireRotation(field, Eigen::Quaterniond(from.linear()))};
}

std::uint32_t Checks::wireSize(const char* field, int value) {
    require(value >= 0, field, "expected no negative number, found {}", value);
    return static_cast<std::uint32_t>(std::max(value, 0));
}

}  // namespace leitstand::detail
