#include "core/mapping/motion/mapping_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/event/cloud_sample.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_description.h"

namespace leitstand {
namespace {

constexpr std::size_t LookedAt = 2'000;    ///< points of a cloud, at most
constexpr std::size_t CellsAcross = 6;     ///< a side of the cube of directions
constexpr double UnsteadyCountsFor = 0.1;  ///< of a steady scanner that sees as much

/// Returns the cell of a direction on a cube about the scanner. Its sides have 6 x 6 cells each, some 15
/// degrees wide. Which way the sensor's frame looks makes no difference.
std::size_t cellOf(const Eigen::Vector3d& direction) {
    Eigen::Index axis = 0;
    const double along = direction.cwiseAbs().maxCoeff(&axis);
    const auto cell = [&](Eigen::Index other) {
        const double angle = std::atan(direction[other % 3] / along);  // within 45 degrees
        return std::min(std::size_t((angle / (std::numbers::pi / 2.0) + 0.5) * double(CellsAcross)),
                        CellsAcross - 1);
    };
    const std::size_t side = 2 * std::size_t(axis) + (direction[axis] < 0.0 ? 1 : 0);
    return (side * CellsAcross + cell(axis + 1)) * CellsAcross + cell(axis + 2);
}

}  // namespace

MappingScanner::MappingScanner(const RobotDescription& robot, const MappingScannerSettings& settings)
    : m_settings(settings) {
    if (robot.stream(StreamRole::Points) == nullptr) return;
    for (const StreamDescription& stream : robot.streams) {
        if (!robot.mayMap(stream)) continue;
        m_topics.push_back(stream.topic);
        if (stream.maps) m_chosen = stream.topic;
    }
    if (m_topics.size() == 1) m_chosen = m_topics.front();
}

bool MappingScanner::compares(const std::string& topic) const {
    return std::find(m_topics.begin(), m_topics.end(), topic) != m_topics.end();
}

bool MappingScanner::takes(const std::string& topic, const CloudSample& cloud, Time received) {
    if (!m_chosen.empty() || m_topics.empty()) return topic == m_chosen || m_topics.empty();
    if (!m_began) m_began = received;
    if (!m_seen.contains(topic)) m_newcomer = received;
    look(m_seen[topic], cloud, received);
    const bool all = m_seen.size() >= m_topics.size();
    if (all ? received - m_newcomer < m_settings.compare : received - *m_began < m_settings.waitForAll)
        return false;
    decide(received);
    return topic == m_chosen;
}

void MappingScanner::decide(Time now) {
    if (!m_chosen.empty()) return;
    double best = 0.0;
    for (const std::string& one : m_topics) {  // in the order of the robot's file, of two alike the first
        const auto seen = m_seen.find(one);
        if (seen == m_seen.end()) continue;
        const double worth = this->worth(seen->second, now);
        if (!m_chosen.empty() && worth <= best) continue;
        best = worth;
        m_chosen = one;
    }
    m_seen.clear();
}

void MappingScanner::look(Seen& seen, const CloudSample& cloud, Time received) const {
    if (seen.clouds > 0) seen.gap = std::max(seen.gap, received - seen.last);
    seen.last = received;
    ++seen.clouds;
    std::vector<double> ranges;
    const std::size_t step = cloud.points.size() / LookedAt + 1;
    for (std::size_t i = 0; i < cloud.points.size(); i += step) {
        const Eigen::Vector3d point = cloud.points[i].cast<double>();
        const double range = point.norm();
        if (!std::isfinite(range) || range < m_settings.nearest) continue;
        ranges.push_back(std::min(range, m_settings.farEnough));
        seen.directions.set(cellOf(point));
    }
    if (ranges.empty()) return;
    const auto ninth = ranges.begin() + std::ptrdiff_t(ranges.size() * 9 / 10);
    std::nth_element(ranges.begin(), ninth, ranges.end());
    seen.reaches.push_back(*ninth);
}

double MappingScanner::worth(const Seen& seen, Time now) const {
    if (seen.reaches.empty()) return 0.0;
    std::vector<double> reaches = seen.reaches;
    const auto middle = reaches.begin() + std::ptrdiff_t(reaches.size() / 2);
    std::nth_element(reaches.begin(), middle, reaches.end());
    const bool steady =
        seen.clouds > 1 && std::max(seen.gap, std::chrono::nanoseconds(now - seen.last)) <= m_settings.steady;
    return double(seen.directions.count()) * *middle * (steady ? 1.0 : UnsteadyCountsFor);
}

std::string planeScanner(const RobotDescription& robot, std::span<const RobotDescription> team) {
    for (const StreamDescription& stream : robot.streams)
        if (stream.role == StreamRole::Ranges && stream.maps) return stream.topic;
    const bool scanned = std::any_of(team.begin(), team.end(), [](const RobotDescription& one) {
        return one.stream(StreamRole::Points) != nullptr;
    });
    const StreamDescription* const laser = robot.stream(StreamRole::Ranges);
    const bool drives = robot.stream(StreamRole::Odometry) != nullptr;
    return !scanned && drives && laser != nullptr ? laser->topic : std::string();
}

}  // namespace leitstand
