#include "app/session/station/robot_sight.h"

#include <chrono>
#include <variant>

namespace leitstand {
namespace {

/// Odometry older than this is not asked for any more: scans come late after a radio gap.
constexpr std::chrono::seconds Kept(90);
constexpr std::chrono::nanoseconds Jump = std::chrono::seconds(5);  ///< of a clock, backwards

VirtualScanSettings scanOf(const RobotDescription& robot) {
    VirtualScanSettings settings;
    settings.body = boxAround(robot.footprint);
    return settings;
}

}  // namespace

RobotSight::RobotSight(const RobotDescription& robot) : m_poses(robot), m_scan(scanOf(robot)) {}

void RobotSight::take(const Event& event) {
    const std::lock_guard lock(m_mutex);
    m_poses.add(event);
    const auto base = [this](Time at) { return m_poses.baseInOdom(at); };
    if (const auto* odometry = std::get_if<OdometrySample>(&event.sample)) {
        const Time stamp = odometry->header.stamp == Time{} ? event.received : odometry->header.stamp;
        if (m_newest && stamp < *m_newest - Jump) m_scan.clear();  // the robot began anew
        if (m_newest && stamp < *m_newest && stamp >= *m_newest - Jump) return;
        m_newest = stamp;
        m_arrived = std::chrono::steady_clock::now();
        m_base = odometry->baseInOdom;
        m_poses.forgetBefore(stamp - Kept);
    } else if (const auto* cloud = std::get_if<CloudSample>(&event.sample)) {
        m_scan.add(*cloud, m_poses.inBase(event.sensor, cloud->header.frame), base);
    } else if (const auto* ranges = std::get_if<RangesSample>(&event.sample)) {
        m_scan.add(*ranges, m_poses.inBase(event.sensor, ranges->header.frame), base);
    }
}

std::optional<VirtualScanView> RobotSight::view() const {
    const std::lock_guard lock(m_mutex);
    if (!m_newest) return std::nullopt;
    return m_scan.view(m_base, *m_newest + (std::chrono::steady_clock::now() - m_arrived));
}

}  // namespace leitstand
