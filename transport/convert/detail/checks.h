#pragma once

#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "core/base/pose.h"
#include "core/event/sample_header.h"
#include "messages/geometry_msgs.h"
#include "messages/std_msgs.h"

namespace leitstand::detail {

/// Converts parts that several messages have in common, in both directions, and keeps the first error.
class Checks {
public:
    /// Keeps the error "field: text" when @p holds is false.
    template <class... Arguments>
    void require(bool holds, const char* field, fmt::format_string<Arguments...> text,
                 Arguments&&... arguments) {
        if (!holds && ok()) fail(field, fmt::format(text, std::forward<Arguments>(arguments)...));
    }
    [[nodiscard]] bool ok() const { return m_error.empty(); }
    [[nodiscard]] const std::string& error() const { return m_error; }

    double finite(const char* field, double value) {
        if (!std::isfinite(value)) fail(field, fmt::format("expected a number, found {}", value));
        return value;
    }
    /// Accepts NaN, which means that the sender does not know the number. Infinity is an error.
    double known(const char* field, double value) {
        if (std::isinf(value)) fail(field, fmt::format("expected a number or NaN, found {}", value));
        return value;
    }
    /// Returns @p value as an enumerator. Error unless it is below @p count.
    template <class Enum>
    Enum enumerator(const char* field, unsigned value, unsigned count) {
        if (value >= count) fail(field, fmt::format("expected less than {}, found {}", count, value));
        return static_cast<Enum>(value);
    }
    int size(const char* field, std::uint32_t value, int most);

    Time time(const char* field, const wire::builtin_interfaces::Time& from);
    std::chrono::nanoseconds duration(const char* field, const wire::builtin_interfaces::Duration& from);
    SampleHeader header(const wire::std_msgs::Header& from);
    template <class Xyz>
    Eigen::Vector3d vector(const char* field, const Xyz& from) {
        return {finite(field, from.x), finite(field, from.y), finite(field, from.z)};
    }
    template <class Xy>
    Eigen::Vector2d vector2(const char* field, const Xy& from) {
        return {finite(field, from.x), finite(field, from.y)};
    }
    /// Whether nobody set @p rotation, which then is no rotation.
    [[nodiscard]] static bool isUnset(const wire::geometry_msgs::Quaternion& rotation) {
        return rotation.x == 0.0 && rotation.y == 0.0 && rotation.z == 0.0 && rotation.w == 0.0;
    }
    Eigen::Quaterniond rotation(const char* field, const wire::geometry_msgs::Quaternion& from);
    Pose pose(const char* field, const wire::geometry_msgs::Pose& from);
    /// Accepts a pose without a rotation, as of senders that care for places alone.
    Pose poseOrPlace(const char* field, wire::geometry_msgs::Pose from) {
        if (isUnset(from.orientation)) from.orientation.w = 1.0;
        return pose(field, from);
    }

    wire::builtin_interfaces::Time wireTime(const char* field, Time from);
    wire::builtin_interfaces::Duration wireDuration(const char* field, std::chrono::nanoseconds from);
    wire::std_msgs::Header wireHeader(const SampleHeader& from);
    template <class Xyz>
    Xyz wireVector(const char* field, const Eigen::Vector3d& from) {
        return {finite(field, from.x()), finite(field, from.y()), finite(field, from.z())};
    }
    wire::geometry_msgs::Pose wirePose(const char* field, const Pose& from);
    wire::geometry_msgs::Quaternion wireRotation(const char* field, const Eigen::Quaterniond& from);
    std::uint32_t wireSize(const char* field, int value);

private:
    void fail(const char* field, const std::string& text);
    std::string m_error;
};

/// Replaces entries that are not finite by 0, which means unknown. Covariances are only a hint about a
/// sensor's error, so they are no reason to refuse a sample.
template <std::size_t N>
std::array<double, N> covariance(std::array<double, N> values) {
    for (double& value : values) value = std::isfinite(value) ? value : 0.0;
    return values;
}

}  // namespace leitstand::detail
