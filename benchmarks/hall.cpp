#include "benchmarks/hall.h"

#include <stdexcept>

#include <fmt/format.h>

#include "core/io/clouds/uos.h"
#include "tests/support/shared_data.h"

namespace leitstand::benchmarks {
namespace {

constexpr float MinRange = 0.48F, MaxRange = 25.0F;  // [m]

HallScan prepared(Scan scan, const Pose& firstInOdom) {
    HallScan result;
    for (const Eigen::Vector3f& point : scan.points) {
        const float range = point.norm();
        if (range >= MinRange && range <= MaxRange) result.cloud.points.push_back(point);
    }
    result.guessInFirst = firstInOdom.inverse() * scan.sensorInOdom;
    result.scan = std::move(scan);
    return result;
}

std::vector<HallScan> readHall() {
    const auto data = test::sharedData();
    if (!data) throw std::runtime_error("the real scans are absent (LEITSTAND_SHARED_DATA)");
    std::vector<HallScan> result;
    for (int i = 0; i < 3; ++i) {
        auto reading = readUosScan(*data / "kurt3d-hall" / fmt::format("scan{:03}.3d", i));
        if (!reading) throw std::runtime_error(reading.error().text);
        Scan scan = std::move(reading).value().scan;
        const Pose first = result.empty() ? scan.sensorInOdom : result.front().scan.sensorInOdom;
        result.push_back(prepared(std::move(scan), first));
    }
    return result;
}

}  // namespace

const std::vector<HallScan>& hall() {
    static const std::vector<HallScan> scans = readHall();
    return scans;
}

std::vector<Eigen::Vector3f> moved(const Pose& pose, const std::vector<Eigen::Vector3f>& points) {
    std::vector<Eigen::Vector3f> result;
    result.reserve(points.size());
    for (const Eigen::Vector3f& point : points) result.push_back((pose * point.cast<double>()).cast<float>());
    return result;
}

}  // namespace leitstand::benchmarks
