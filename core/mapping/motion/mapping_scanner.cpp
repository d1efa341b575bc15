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
    for (const StreamRole role : {StreamRole::Points, StreamRole::Ranges}) {
        for (const StreamDescription& stream : robot.streams) {
            if (stream.role != role || !robot.mayMap(stream)) continue;
            m_topics.push_back(stream.topic);
            if (stream.maps) m_chosen = stream.topic;
        }
        if (role == StreamRole::Points) m_clouds = m_topics.size();
    }
    if (m_topics.size() == 1) m_chosen = m_topics.front();
}

bool MappingScanner::compares(const std::string& topic) const {
    return std::find(m_topics.begin(), m_topics.end(), topic) != m_topics.end();
}

bool MappingScanner::isCloud(const std::string& topic) const {
    const auto end = m_topics.begin() + std::ptrdiff_t(m_clouds);
    return std::find(m_topics.begin(), end, topic) != end;
}

bool MappingScanner::takes(const std::string& topic, const CloudSample& cloud, Time received) {
    if (!m_chosen.empty() || m_topics.empty()) return topic == m_chosen || m_topics.empty();
    const bool first = !m_seen.contains(topic);
    if (isCloud(topic)) {
        if (!m_began) m_began = received;
        if (first) m_newcomer = received;
    } else if (!m_began) {
        return false;  // nothing to compare it with
    }
    look(m_seen[topic], cloud, received);
    const auto clouds =
        std::count_if(m_seen.begin(), m_seen.end(), [this](const auto& one) { return isCloud(one.first); });
    const bool all = std::size_t(clouds) >= m_clouds;
    if (all ? received - m_newcomer < m_settings.compare : received - *m_began < m_settings.waitForAll)
        return false;
    decide(received);
    return topic == m_chosen;
}

std::pair<std::string, double> MappingScanner::best(std::size_t first, std::size_t last, Time now) const {
    std::pair<std::string, double> found;
    double most = 0.0;
    for (std::size_t i = first; i < last; ++i) {  // in the order of the robot's file, of two alike the first
        const auto seen = m_seen.find(m_topics[i]);
        if (seen == m_seen.end()) continue;
        const double worth = this->worth(seen->second, now);
        if (!found.first.empty() && worth <= most) continue;
        most = worth;
        found = {m_topics[i], this->worth(seen->second, {})};
    }
    return found;
}

void MappingScanner::decide(Time now) {
    if (!m_chosen.empty()) return;
    const auto cloud = best(0, m_clouds, now), laser = best(m_clouds, m_topics.size(), now);
    // A scanner that stops for each scan is slow, and sees more all the same.
    m_chosen = laser.first.empty() || cloud.second >= laser.second ? cloud.first : laser.first;
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

double MappingScanner::worth(const Seen& seen, std::optional<Time> now) const {
    if (seen.reaches.empty()) return 0.0;
    std::vector<double> reaches = seen.reaches;
    const auto middle = reaches.begin() + std::ptrdiff_t(reaches.size() / 2);
    std::nth_element(reaches.begin(), middle, reaches.end());
    const bool steady =
        !now || (seen.clouds > 1 &&
                 std::max(seen.gap, std::chrono::nanoseconds(*now - seen.last)) <= m_settings.steady);
    return double(seen.directions.count()) * *middle * (steady ? 1.0 : UnsteadyCountsFor);
}

std::string planeLaserOf(const RobotDescription& robot) {
    std::string first;
    for (const StreamDescription& stream : robot.streams) {
        if (stream.role != StreamRole::Ranges || !(stream.maps || robot.mayMap(stream))) continue;
        if (stream.maps) return stream.topic;
        if (first.empty()) first = stream.topic;
    }
    return first;
}

std::string planeScanner(const RobotDescription& robot, std::span<const RobotDescription> team) {
    for (const StreamDescription& stream : robot.streams)
        if (stream.role == StreamRole::Ranges && stream.maps) return stream.topic;
    const bool scanned = std::any_of(team.begin(), team.end(), [](const RobotDescription& one) {
        return one.stream(StreamRole::Points) != nullptr;
    });
    return scanned ? std::string() : planeLaserOf(robot);
}

}  // namespace leitstand
