#include "app/services/mapping/scanner_advice.h"

#include <algorithm>
#include <utility>

#include "app/services/log/mission_robots.h"
#include "core/event/stream_role.h"
#include "core/io/robot/editing/robot_edits.h"

namespace leitstand {
namespace fs = std::filesystem;

std::string mappingSensor(const RobotDescription& robot) {
    const StreamDescription* const maps = robot.mappingStream();
    return maps != nullptr ? maps->sensor : std::string();
}

ScannerAdvice::ScannerAdvice(std::vector<RobotDescription> robots, fs::path mission)
    : m_robots(std::move(robots)), m_mission(std::move(mission)) {}

std::vector<RobotDescription>::iterator ScannerAdvice::find(const std::string& robot) {
    return std::find_if(m_robots.begin(), m_robots.end(),
                        [&](const RobotDescription& one) { return one.name == robot; });
}

bool ScannerAdvice::follow(const std::string& robot, const ScannerFinding& finding) {
    const std::lock_guard lock(m_mutex);
    const auto described = find(robot);
    if (described == m_robots.end()) return false;
    const auto sensor = described->sensors.find(mappingSensor(*described));
    const ScannerCorrection now =
        sensor == described->sensors.end() ? ScannerCorrection{} : sensor->second.correction;
    // On its way while the operator answered: it advises what use() already did.
    if (finding.present != now) return false;
    m_advised.erase(robot);
    if (!finding.more || now.with(*finding.more) == now) return false;  // none, or at the limits
    m_advised.emplace(robot, *finding.more);
    return m_reported.emplace(robot, faultOf(*finding.more)).second;
}

Result<void> ScannerAdvice::mapWith(const std::string& robot, const std::string& topic) {
    const std::lock_guard lock(m_mutex);  // also over the file, which use() writes, too
    const auto described = find(robot);
    if (described == m_robots.end()) return {};
    for (StreamDescription& stream : described->streams) stream.maps = stream.topic == topic;
    // What was advised of the scanner before is not about this one.
    m_advised.erase(robot);
    std::erase_if(m_reported, [&](const auto& one) { return one.first == robot; });
    return m_mission.empty() ? Result<void>() : keepRobots(m_mission, {*described});
}

std::optional<StreamRole> ScannerAdvice::mappingRole(const std::string& robot,
                                                     const std::string& topic) const {
    const std::lock_guard lock(m_mutex);
    for (const RobotDescription& one : m_robots) {
        for (const StreamDescription& stream : one.streams)
            if (one.name == robot && stream.topic == topic && one.mayMap(stream)) return stream.role;
    }
    return std::nullopt;
}

std::string ScannerAdvice::mapsWith(const std::string& robot) const {
    const std::lock_guard lock(m_mutex);
    const auto described =
        std::find_if(m_robots.begin(), m_robots.end(), [&](const auto& one) { return one.name == robot; });
    const StreamDescription* const maps = described == m_robots.end() ? nullptr : described->mappingStream();
    return maps != nullptr ? maps->topic : std::string();
}

std::optional<ScannerQuestion> ScannerAdvice::question() const {
    const std::lock_guard lock(m_mutex);
    if (m_advised.empty()) return std::nullopt;
    const auto& [robot, more] = *m_advised.begin();
    return ScannerQuestion{robot, more};
}

void ScannerAdvice::leave(const ScannerQuestion& question) {
    const std::lock_guard lock(m_mutex);
    const auto asked = m_advised.find(question.robot);
    if (asked != m_advised.end() && faultOf(asked->second) == faultOf(question.more)) m_advised.erase(asked);
}

ScannerAdvice::Used ScannerAdvice::use(const ScannerQuestion& question) {
    Used used;
    RobotDescription corrected;
    std::string sensor;
    {
        const std::lock_guard lock(m_mutex);
        m_advised.erase(question.robot);
        m_reported.erase({question.robot, faultOf(question.more)});
        const auto robot = find(question.robot);
        if (robot == m_robots.end()) return used;
        sensor = mappingSensor(*robot);
        SensorDescription& described =
            robot->sensors.try_emplace(sensor, SensorDescription{.frame = sensor}).first->second;
        used.total = described.correction = described.correction.with(question.more);
        corrected = *robot;
        if (!m_mission.empty()) {
            if (const auto kept = keepRobots(m_mission, {corrected}); !kept)
                used.notWritten = kept.error().text;
        }
    }
    if (corrected.file.empty()) return used;
    const auto file = editRobotFile(corrected.file, [&](const std::string& text, const std::string& name) {
        return withCorrection(text, name, sensor, used.total);
    });
    if (file) {
        used.file = *file;
    } else {
        used.notWritten = file.error().text;
    }
    return used;
}

}  // namespace leitstand
