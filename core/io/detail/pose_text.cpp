#include "core/io/detail/pose_text.h"

#include <array>
#include <cmath>

#include "core/io/detail/numbers.h"

namespace leitstand::detail {
namespace {

constexpr double Farthest = 100'000.0;  ///< largest coordinate of a position [m]

}  // namespace

std::optional<std::string_view> takePose(std::string_view line, Pose& into, std::string_view expectation) {
    std::array<double, 7> numbers{};
    for (double& number : numbers) {
        const auto value = toNumber(takeField(line));
        if (!value || !std::isfinite(*value)) return expectation;
        number = *value;
    }
    if (!takeField(line).empty()) return expectation;
    const Eigen::Vector3d position(numbers[0], numbers[1], numbers[2]);
    if (position.cwiseAbs().maxCoeff() > Farthest) return "a position within 100 km";
    const Eigen::Quaterniond rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
    if (!(std::abs(rotation.norm() - 1.0) <= 0.01)) return "a quaternion of length 1";
    into.setIdentity();
    into.translation() = position;
    into.linear() = rotation.normalized().toRotationMatrix();
    return std::nullopt;
}

}  // namespace leitstand::detail
