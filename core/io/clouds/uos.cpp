#include "core/io/clouds/uos.h"

#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/io/clouds/detail/point_text.h"
#include "core/io/clouds/detail/uos_axes.h"
#include "core/io/detail/numbers.h"
#include "core/io/detail/output_file.h"

namespace leitstand {

namespace fs = std::filesystem;

namespace {

fs::path poseBeside(fs::path file3d) {
    return file3d.replace_extension(".pose");
}

Result<void> readOdometry(const fs::path& file, ScanReading& into) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(file, ignored))) {
        into.warnings.push_back(file.string() + ": is missing, the scan has no odometry");
        return {};
    }
    const auto pose = readUosPose(file);
    if (!pose) return pose.error();
    into.scan.sensorInOdom = *pose;
    into.scan.hasOdometry = true;
    return {};
}

void appendPoint(std::string& text, const Eigen::Vector3f& point) {
    if (!point.allFinite()) {
        text += "0 0 0";
        return;
    }
    detail::appendCentimetres(text, -point.y());
    text += ' ';
    detail::appendCentimetres(text, point.z());
    text += ' ';
    detail::appendCentimetres(text, point.x());
}

}  // namespace

Result<ScanReading> readUosScan(const fs::path& file3d) {
    auto read = detail::readPointText(
        file3d, {.gridHeader = true, .zeroIsNoEcho = true, .toMetres = &detail::fromUos});
    if (!read) return read;
    ScanReading reading = std::move(read).value();
    if (auto odometry = readOdometry(poseBeside(file3d), reading); !odometry) return odometry.error();
    return reading;
}

Result<void> writeUosPoints(const fs::path& file3d, const Scan& scan) {
    auto created = detail::OutputFile::create(file3d);
    if (!created) return created.error();
    detail::OutputFile out = std::move(created).value();
    if (scan.organised()) out.write(fmt::format("{} x {}\n", scan.rows, scan.columns));
    std::string line;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        line.clear();
        appendPoint(line, scan.points[i]);
        if (!scan.intensities.empty()) {
            line += ' ';
            detail::appendNumber(line, scan.intensities[i]);
        }
        line += '\n';
        out.write(line);
    }
    return out.commit();
}

Result<void> writeUosScan(const fs::path& file3d, const Scan& scan) {
    if (auto points = writeUosPoints(file3d, scan); !points) return points;
    const fs::path pose = poseBeside(file3d);
    if (scan.hasOdometry) return writeUosPose(pose, scan.sensorInOdom);
    std::error_code problem;
    fs::remove(pose, problem);
    if (problem) return Error{fmt::format("{}: cannot be removed: {}", pose.string(), problem.message())};
    return {};
}

}  // namespace leitstand
