#include "app/services/mapping/robots/robot_placing.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/services/log/sequencer.h"
#include "app/services/mapping/robots/mapping_context.h"
#include "core/mapping/sighting/seen_bodies.h"

namespace leitstand {
namespace {

// A robot that is placed nowhere maps a part of its own after so many scans ...
constexpr int Unplaced = 3;
// ... and when its scans go over so much time: some scanners make ten a second.
constexpr std::chrono::milliseconds UnplacedFor(800);

}  // namespace

void RobotPlacing::seeing(const std::string& name, MappedRobot& robot, LaserView view, Time now) {
    if (const LiveKeyScan* const first = firstOfOurs()) {
        // Nobody knows how the area lies relative to another part of the map.
        const Pose here = robot.tracker.placed() ? robot.tracker.now().baseInMap : first->pose.scanInMap;
        robot.laser.setCrop(partAt(m_context.map->scans, here) == 0 ? m_context.crop : MapCrop{});
    }
    publish(robot.laser.see(std::move(view), m_context.map, now, m_robots.othersThan(robot, false)));
    placeBeside(name, robot, now);
}

void RobotPlacing::publish(const std::optional<RobotPlaceSample>& place) const {
    if (place && m_context.listener.onPlace) m_context.listener.onPlace(*place);
}

const LiveKeyScan* RobotPlacing::firstOfOurs() const {
    if (!m_context.map || m_context.map->scans.empty()) return nullptr;
    const auto ours =
        std::find_if(m_context.map->scans.begin(), m_context.map->scans.end(),
                     [&](const LiveKeyScan& scan) { return m_robots.contains(scan.scan->robot); });
    return ours != m_context.map->scans.end() ? &*ours : &m_context.map->scans.front();
}

void RobotPlacing::placeBeside(const std::string& name, MappedRobot& robot, Time now) {
    if (!m_context.map || m_context.map->scans.empty()) return;
    const LiveKeyScan& first = *firstOfOurs();
    if (name == first.scan->robot || m_context.mapper.fix(name)) return;
    publish(robot.laser.placeBeside(first.pose.scanInMap * first.sensorInBase.inverse(), m_context.map, now,
                                    m_robots.othersThan(robot, false)));
}

void RobotPlacing::placeOthers(Time now) {
    for (auto& [name, robot] : m_robots.byName()) placeBeside(name, robot, now);
}

void RobotPlacing::placeSeen(const MapUpdate& update, const LiveMapPtr& before, Time now) {
    if (!update.ready || update.localisation.trust != ScanTrust::Certain) return;
    const std::string& name = update.localisation.robot;
    const auto by = std::find_if(m_robots.descriptions().begin(), m_robots.descriptions().end(),
                                 [&](const RobotDescription& one) { return one.name == name; });
    for (const RobotDescription& description : m_robots.descriptions()) {
        MappedRobot& robot = m_robots.at(description.name);
        if (description.name == name || m_context.mapper.fix(description.name) || !robot.laser.wantsSeen())
            continue;
        const RobotBody body{description.footprint, description.height};
        const LocalMap earlier = before ? localMap(before->scans, update.scanInMap) : LocalMap{};
        const auto seen =
            seenBodies(*update.ready, update.scanInMap, body, earlier, m_robots.othersThan(robot, true));
        publish(robot.laser.placeSeen(seen, body, by->title, m_context.map, now,
                                      m_robots.othersThan(robot, false)));
    }
}

void RobotPlacing::place(MappedRobot& robot, const LiveScan& scan, Time now) {
    const std::string& name = scan.scan->robot;
    if (!m_context.map || m_context.map->scans.empty() || m_context.mapper.fix(name)) return;
    // Without a plane laser its 3D scans serve as well.
    if (!robot.tracker.placed() || robot.laser.resumes()) seeing(name, robot, laserView(scan), now);
    if (const auto there = robot.tracker.baseInMap(scan.scan->end))
        return m_context.mapper.place(name, *there);
    const auto waits = m_unplaced.try_emplace(name, Waits{0, scan.scan->end}).first;
    waits->second.since = std::min(waits->second.since, scan.scan->end);  // its clock may be set back
    if (++waits->second.scans >= Unplaced && scan.scan->end - waits->second.since >= UnplacedFor)
        m_context.mapper.beginPart(name);
}

void RobotPlacing::put(const std::string& name, const Pose& baseInMap) {
    LaserRobot& laser = m_robots.at(name).laser;
    if (const auto fix = m_context.mapper.fix(name)) {
        m_context.mapper.place(name, baseInMap);
        return publish(laser.putUntilScan(baseInMap, fix->stamp, stationTime()));
    }
    publish(laser.place(baseInMap, m_context.map, stationTime()));
}

void RobotPlacing::follow(const RobotPlaceSample& place) {
    if (m_robots.contains(place.robot) && !m_context.mapper.fix(place.robot))
        m_robots.at(place.robot).laser.follow(place);
}

}  // namespace leitstand
