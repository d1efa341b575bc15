#include <algorithm>
#include <optional>
#include <utility>

#include "app/services/log/sequencer.h"
#include "app/services/mapping/live_mapping.h"
#include "core/mapping/sighting/other_bodies.h"
#include "core/mapping/sighting/seen_bodies.h"

namespace leitstand {
namespace {

constexpr double AboutARobot = 0.1;  ///< so much about its corners may be of a robot, too [m]

}  // namespace

std::vector<Disc> LiveMapping::othersThan(const Robot& robot, bool certain) const {
    std::vector<Disc> others;
    for (const RobotDescription& description : m_descriptions) {
        const Robot& other = m_robots.at(description.name);
        if (&other == &robot || !other.tracker.placed() || (certain && !other.tracker.now().certain))
            continue;
        Disc disc{other.tracker.now().baseInMap.translation().head<2>(), 0.0};
        for (const Eigen::Vector2d& corner : description.footprint)
            disc.radius = std::max(disc.radius, corner.norm() + AboutARobot);
        others.push_back(disc);
    }
    return others;
}

std::vector<PlacedBody> LiveMapping::bodiesIn(const Scan& scan) const {
    std::vector<PlacedBody> bodies;
    const Robot& seeing = m_robots.at(scan.robot);
    for (const RobotDescription& description : m_descriptions) {
        const Robot& other = m_robots.at(description.name);
        if (&other == &seeing) continue;
        const auto later = other.ahead - seeing.ahead;
        addBodies(bodies, other.tracker, {description.footprint, description.height}, scan.start + later,
                  scan.end + later);
    }
    return bodies;
}

bool LiveMapping::leaveOutPlaced() {
    bool becameCertain = false;
    for (auto& [name, robot] : m_robots) {
        const bool certain = robot.tracker.now().certain;
        becameCertain = becameCertain || (certain && !robot.certain);
        robot.certain = certain;
    }
    if (!becameCertain || !m_map) return false;
    bool changed = false;
    for (const LiveKeyScan& one : m_map->scans) {
        if (one.odometryFrame < 0 || !m_robots.contains(one.scan->robot)) continue;
        std::vector<PlacedBody> bodies = bodiesIn(*one.scan);
        if (!bodies.empty() && m_mapper.leaveOut(one.id, std::move(bodies))) changed = true;
    }
    return changed;
}

void LiveMapping::seeing(const std::string& name, Robot& robot, LaserView view, Time now) {
    tellPlace(robot.laser.see(std::move(view), m_map, now, othersThan(robot, false)));
    placeBeside(name, robot, now);
}

void LiveMapping::tellPlace(const std::optional<RobotPlaceSample>& place) {
    if (place && m_listener.onPlace) m_listener.onPlace(*place);
}

void LiveMapping::placeBeside(const std::string& name, Robot& robot, Time now) {
    if (!m_map || m_map->scans.empty()) return;
    const LiveKeyScan& first = m_map->scans.front();
    if (name == first.scan->robot || m_mapper.fix(name)) return;
    tellPlace(robot.laser.placeBeside(first.pose.scanInMap * first.sensorInBase.inverse(), m_map, now,
                                      othersThan(robot, false)));
}

void LiveMapping::placeOthers(Time now) {
    for (auto& [name, robot] : m_robots) placeBeside(name, robot, now);
}

void LiveMapping::placeSeen(const MapUpdate& update, const LiveMapPtr& before, Time now) {
    if (!update.ready || update.localisation.trust != ScanTrust::Certain) return;
    const std::string& name = update.localisation.robot;
    const auto by = std::find_if(m_descriptions.begin(), m_descriptions.end(),
                                 [&](const RobotDescription& one) { return one.name == name; });
    for (const RobotDescription& description : m_descriptions) {
        Robot& robot = m_robots.at(description.name);
        if (description.name == name || m_mapper.fix(description.name) || !robot.laser.wantsSeen()) continue;
        const RobotBody body{description.footprint, description.height};
        const LocalMap earlier = before ? localMap(before->scans, update.scanInMap) : LocalMap{};
        const auto seen = seenBodies(*update.ready, update.scanInMap, body, earlier, othersThan(robot, true));
        tellPlace(robot.laser.placeSeen(seen, body, by->title, m_map, now, othersThan(robot, false)));
    }
}

void LiveMapping::place(Robot& robot, const LiveScan& scan, Time now) {
    const std::string& name = scan.scan->robot;
    if (!m_map || m_map->scans.empty() || m_mapper.fix(name)) return;
    // Without a plane laser its 3D scans do as well.
    if (!robot.tracker.placed() || robot.laser.resumes()) seeing(name, robot, laserView(scan), now);
    if (const auto there = robot.tracker.baseInMap(scan.scan->end)) m_mapper.place(name, *there);
}

void LiveMapping::adopt(const KeyScanSample& keyScan) {
    post([this, keyScan](LiveMapper& mapper) {
        mapper.adopt(keyScan);
        for (auto& [name, robot] : m_robots) robot.matched.reset();  // it is matched over there
    });
}

void LiveMapping::adopt(const ScanLinksSample& links) {
    post([links](LiveMapper& mapper) { mapper.restore(links); });
}

void LiveMapping::heard(const std::string& robot, Time received) {
    const std::lock_guard lock(m_mutex);
    m_heard[robot] = received;
}

void LiveMapping::matched(const std::string& name, Time now) {
    m_robots.at(name).matched = now;
    const std::lock_guard lock(m_mutex);
    m_heard.erase(name);
}

void LiveMapping::follow(std::vector<ScanPose> poses) {
    post([poses = std::move(poses)](LiveMapper& mapper) { mapper.follow(poses); });
}

void LiveMapping::follow(const RobotPlaceSample& place) {
    post([this, place](LiveMapper& mapper) {
        const auto robot = m_robots.find(place.robot);
        if (robot != m_robots.end() && !mapper.fix(place.robot)) robot->second.laser.follow(place);
    });
}

void LiveMapping::place(const std::string& name, const Pose& baseInMap) {
    post([this, name, baseInMap](LiveMapper& mapper) {
        Robot& robot = m_robots.at(name);
        if (const auto fix = mapper.fix(name)) {
            mapper.place(name, baseInMap);
            return tellPlace(robot.laser.putUntilScan(baseInMap, fix->stamp, stationTime()));
        }
        tellPlace(robot.laser.place(baseInMap, m_map, stationTime()));
    });
}

}  // namespace leitstand
