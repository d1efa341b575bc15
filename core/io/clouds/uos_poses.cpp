#include "core/io/clouds/uos.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/io/clouds/detail/point_sink.h"
#include "core/io/clouds/detail/uos_axes.h"
#include "core/io/detail/line_reader.h"
#include "core/io/detail/numbers.h"
#include "core/io/detail/output_file.h"

namespace leitstand {

namespace fs = std::filesystem;

namespace {

constexpr double RotationTolerance = 1e-3;  // 3DTK writes six digits

Eigen::Matrix3d rotationFromEuler(const Eigen::Vector3d& angles) {
    return (Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

/// Returns angles about x, y, z with R = Rx Ry Rz [rad]; when y is 90 degrees, z is 0.
Eigen::Vector3d eulerFromRotation(const Eigen::Matrix3d& r) {
    const double cosY = std::hypot(r(0, 0), r(0, 1));
    const double y = std::atan2(r(0, 2), cosY);
    if (cosY < 1e-9) return {std::atan2(r(2, 1), r(1, 1)), y, 0.0};
    return {std::atan2(-r(1, 2), r(2, 2)), y, std::atan2(-r(0, 1), r(0, 0))};
}

bool withinReach(const Eigen::Vector3d& position) {
    return position.allFinite() && position.cwiseAbs().maxCoeff() <= detail::MaxCoordinate;
}

/// Returns the pose in 16 numbers of a left-handed, column-major matrix [cm]; empty when they are no pose.
std::optional<Pose> toPose(const std::array<double, 17>& numbers) {
    const Eigen::Map<const Eigen::Matrix4d> matrix(numbers.data());
    if (!matrix.allFinite()) return std::nullopt;
    const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
    const bool orthonormal =
        (rotation * rotation.transpose()).isIdentity(RotationTolerance) && rotation.determinant() > 0.0;
    const bool affine = (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() < 1e-6;
    Pose pose = Pose::Identity();
    pose.translation() = detail::fromUos(matrix.topRightCorner<3, 1>());
    if (!orthonormal || !affine || !withinReach(pose.translation())) return std::nullopt;
    pose.linear() = detail::rotationFromUos(rotation);
    return orthonormalised(pose);
}

std::optional<UosFrame> toFrame(std::string_view line) {
    std::array<double, 17> numbers{};
    for (double& number : numbers) {
        const auto value = detail::toNumber(detail::takeField(line));
        if (!value) return std::nullopt;
        number = *value;
    }
    const double colour = numbers[16];
    if (!detail::takeField(line).empty() || !(std::abs(colour) < 1e6)) return std::nullopt;
    const auto pose = toPose(numbers);
    if (!pose) return std::nullopt;
    return UosFrame{*pose, static_cast<int>(colour)};
}

}  // namespace

Result<Pose> readUosPose(const fs::path& file) {
    auto opened = detail::LineReader::open(file);
    if (!opened) return opened.error();
    detail::LineReader reader = std::move(opened).value();
    constexpr std::string_view Expectation = "six numbers: x y z [cm], then three angles [degrees]";
    std::array<double, 6> numbers{};
    std::size_t count = 0;
    std::string_view line;
    while (reader.next(line)) {
        std::string_view rest = line;
        for (auto field = detail::takeField(rest); !field.empty(); field = detail::takeField(rest)) {
            const auto number = detail::toNumber(field);
            if (count == numbers.size() || !number || !std::isfinite(*number)) {
                return reader.mismatch(Expectation, line);
            }
            numbers[count++] = *number;
        }
    }
    if (reader.failure()) return *reader.failure();
    if (count != numbers.size()) {
        return reader.incomplete(fmt::format("{}, found {} numbers", Expectation, count));
    }
    Pose pose = Pose::Identity();
    pose.translation() = detail::fromUos({numbers[0], numbers[1], numbers[2]});
    if (!withinReach(pose.translation())) return reader.incomplete("a position within 100 km");
    pose.linear() = detail::rotationFromUos(
        rotationFromEuler({degrees(numbers[3]), degrees(numbers[4]), degrees(numbers[5])}));
    return pose;
}

Result<void> writeUosPose(const fs::path& file, const Pose& pose) {
    const Eigen::Vector3d position = detail::toUos(pose.translation());
    const Eigen::Vector3d angles = eulerFromRotation(detail::rotationToUos(pose.linear()));
    return detail::writeWhole(
        file, fmt::format("{} {} {}\n{} {} {}\n", position.x(), position.y(), position.z(),
                          inDegrees(angles.x()), inDegrees(angles.y()), inDegrees(angles.z())));
}

Result<std::vector<UosFrame>> readUosFrames(const fs::path& file) {
    auto opened = detail::LineReader::open(file);
    if (!opened) return opened.error();
    detail::LineReader reader = std::move(opened).value();
    std::vector<UosFrame> frames;
    std::string_view line;
    while (reader.next(line)) {
        std::string_view rest = line;
        if (detail::takeField(rest).empty()) continue;
        const auto frame = toFrame(line);
        if (!frame) return reader.mismatch("a column-major 4x4 rigid motion and a colour", line);
        frames.push_back(*frame);
    }
    if (reader.failure()) return *reader.failure();
    if (frames.empty()) return reader.incomplete("frames, found none");
    return frames;
}

Result<void> writeUosFrames(const fs::path& file, const std::vector<UosFrame>& frames) {
    std::string text;
    for (const UosFrame& frame : frames) {
        Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
        matrix.topLeftCorner<3, 3>() = detail::rotationToUos(frame.pose.linear());
        matrix.topRightCorner<3, 1>() = detail::toUos(frame.pose.translation());
        for (const double number : matrix.reshaped()) {
            detail::appendNumber(text, number);
            text += ' ';
        }
        text += fmt::format("{}\n", frame.colour);
    }
    return detail::writeWhole(file, text);
}

}  // namespace leitstand
