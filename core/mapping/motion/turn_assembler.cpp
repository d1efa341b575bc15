#include "core/mapping/motion/turn_assembler.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/cloud/labels.h"

namespace leitstand {
namespace {

constexpr double FullTurn = 2.0 * std::numbers::pi;
constexpr double SliceTurn = degrees(300);            ///< a cloud that covers more is a whole sweep
constexpr double RawScanWidth = degrees(8);           ///< vertical raw scans are narrower, seen from above
constexpr double LeastTurn = degrees(180);            ///< of an interrupted turn, to be a scan
constexpr std::chrono::milliseconds LongestGap(700);  ///< between slices of one turn
constexpr float LeastReach = 0.2F;  ///< points nearer to the turning axis have no heading [m]

double wrapped(double angle) {
    return std::remainder(angle, FullTurn);
}

/// The direction of a raw scan.
struct Heading {
    double mean = 0.0;   ///< [rad]
    double width = 0.0;  ///< of nine tenths of its points, around the mean [rad]
};

/// Returns the heading of row @p row about the z axis; empty if it has too few points.
std::optional<Heading> headingOf(const CloudSample& cloud, int row) {
    const auto width = static_cast<std::size_t>(cloud.columns);
    const auto first =
        cloud.points.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * width);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    std::vector<double> angles;
    for (auto point = first; point != first + cloud.columns; ++point) {
        const float reach = point->head<2>().norm();
        if (!(reach > LeastReach) || !std::isfinite(reach)) continue;
        sum += point->head<2>().cast<double>() / double(reach);
        angles.push_back(std::atan2(double(point->y()), double(point->x())));
    }
    if (angles.size() < 3 || sum.isZero()) return std::nullopt;
    const double mean = std::atan2(sum.y(), sum.x());
    for (double& angle : angles) angle = std::abs(wrapped(angle - mean));
    const auto most = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() * 9 / 10);
    std::nth_element(angles.begin(), most, angles.end());
    return Heading{mean, 2.0 * *most};
}

/// Returns headings of the raw scans of a yawing scanner's slice; empty if @p cloud is anything else.
std::vector<double> headingsOfSlice(const CloudSample& cloud) {
    if (!cloud.organised()) return {};
    std::vector<double> headings, widths;
    for (int row = 0; row < cloud.rows; ++row) {
        if (const auto heading = headingOf(cloud, row)) {
            headings.push_back(heading->mean);
            widths.push_back(heading->width);
        }
    }
    if (headings.empty()) return {};
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    double turned = 0.0;
    for (std::size_t i = 1; i < headings.size(); ++i)
        turned += std::abs(wrapped(headings[i] - headings[i - 1]));
    return *middle < RawScanWidth && turned < SliceTurn ? headings : std::vector<double>();
}

void append(Scan& scan, const CloudSample& cloud, const Pose& cloudInScan) {
    const Eigen::Isometry3f motion = cloudInScan.cast<float>();
    scan.points.reserve(scan.points.size() + cloud.points.size());
    for (const Eigen::Vector3f& point : cloud.points) scan.points.push_back(motion * point);
    scan.intensities.insert(scan.intensities.end(), cloud.intensities.begin(), cloud.intensities.end());
}

Scan wholeSweep(const CloudSample& cloud, const std::optional<Pose>& sensorInOdom) {
    Scan scan;
    scan.start = cloud.header.stamp;
    scan.end = endOf(cloud);
    scan.hasOdometry = sensorInOdom.has_value();
    scan.sensorInOdom = sensorInOdom.value_or(Pose::Identity());
    scan.rows = cloud.rows;
    scan.columns = cloud.columns;
    scan.points = cloud.points;
    scan.intensities = cloud.intensities;
    return scan;
}

/// Puts the points of a plane laser back into its plane, which its robot tilted within the turn.
void flatten(CloudSample& cloud) {
    for (Eigen::Vector3f& point : cloud.points)
        if (point.allFinite()) point.z() = 0.0F;
}

}  // namespace

bool TurnAssembler::continues(const CloudSample& cloud) const {
    const CloudSample& last = m_slices.back().cloud;
    const auto pause = cloud.header.stamp - endOf(last);
    return cloud.columns == last.columns && cloud.header.frame == last.header.frame && pause <= LongestGap &&
           pause >= -LongestGap;
}

bool TurnAssembler::takesTooLong(const CloudSample& cloud) const {
    const auto since = endOf(cloud) - m_slices.front().cloud.header.stamp;
    if (since <= m_settings.longestTime) return false;
    // A slow scanner may take longer while it turns.
    const double turns = std::chrono::duration<double>(since) / m_settings.slowestTurn;
    return m_turned < 2.0 * std::numbers::pi * turns;
}

void TurnAssembler::gather(CloudSample cloud, const std::optional<Pose>& sensorInOdom) {
    if (!m_slices.empty() && m_slices.back().sensorInOdom && sensorInOdom) {
        m_way += distanceBetween(*m_slices.back().sensorInOdom, *sensorInOdom);
        m_rotated += angleBetween(*m_slices.back().sensorInOdom, *sensorInOdom);
    }
    m_slices.push_back({std::move(cloud), sensorInOdom});
}

bool TurnAssembler::movedTooFar() const {
    return m_way > m_settings.longestWay || m_rotated > m_settings.mostTurned;
}

std::optional<Scan> TurnAssembler::add(CloudSample cloud, const SensorTrack& track) {
    const std::vector<double> headings = headingsOfSlice(cloud);
    const bool plane = isPlaneScan(cloud.points);
    const std::optional<Pose> sensorInOdom = takeMotionOut(cloud, track);
    if (plane) flatten(cloud);
    // A slice that saw nothing belongs to its turn.
    const bool blind = headings.empty() && !m_slices.empty() && cloud.organised() &&
                       cloud.columns == m_slices.front().cloud.columns &&
                       std::none_of(cloud.points.begin(), cloud.points.end(),
                                    [](const Eigen::Vector3f& point) { return point.allFinite(); });
    if (headings.empty() && !blind) {
        m_ended = TurnEnd::Sweep;
        return wholeSweep(cloud, sensorInOdom);
    }
    std::optional<Scan> complete;
    if (!m_slices.empty() && (!continues(cloud) || takesTooLong(cloud))) complete = finish();
    for (const double heading : headings) {
        if (m_lastHeading) m_turned += std::abs(wrapped(heading - *m_lastHeading));
        m_lastHeading = heading;
        ++m_rows;
    }
    gather(std::move(cloud), sensorInOdom);
    // Whether the last raw scan repeats the first one's direction depends on the scanner: one step less is a
    // turn.
    const double step = m_turned / std::max(1, m_rows - 1);
    if (complete || blind) return complete;
    if (m_turned >= FullTurn - 1.25 * step) return take(TurnEnd::Turn);
    return movedTooFar() ? take(TurnEnd::Distance) : std::nullopt;
}

std::optional<Scan> TurnAssembler::finish() {
    if (!m_slices.empty() && m_turned >= m_settings.leastTurn) return take(TurnEnd::Break);
    m_slices.clear();
    forget();
    return std::nullopt;
}

void TurnAssembler::forget() {
    m_turned = 0.0;
    m_rows = 0;
    m_lastHeading.reset();
    m_way = m_rotated = 0.0;
}

std::optional<Scan> TurnAssembler::take(TurnEnd end) {
    const std::vector<Slice> slices = std::exchange(m_slices, {});
    forget();
    m_ended = end;
    const Slice& last = slices.back();
    m_began = slices.front().sensorInOdom && last.sensorInOdom
                  ? (last.sensorInOdom->inverse() * *slices.front().sensorInOdom).translation()
                  : Eigen::Vector3d(Eigen::Vector3d::Zero());
    Scan scan;
    scan.sweep = Sweep::Yawing;
    scan.start = slices.front().cloud.header.stamp;
    scan.end = endOf(last.cloud);
    scan.hasOdometry = last.sensorInOdom.has_value();
    scan.sensorInOdom = last.sensorInOdom.value_or(Pose::Identity());
    scan.columns = last.cloud.columns;
    for (const Slice& slice : slices) {
        scan.rows += slice.cloud.rows;
        const bool moved = slice.sensorInOdom && last.sensorInOdom;
        append(scan, slice.cloud,
               moved ? last.sensorInOdom->inverse() * *slice.sensorInOdom : Pose::Identity());
    }
    if (scan.intensities.size() != scan.points.size()) scan.intensities.clear();
    return scan;
}

}  // namespace leitstand
