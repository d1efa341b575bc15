#include "app/services/mapping/robots/mapped_robots.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>

#include "app/services/mapping/robots/mapping_context.h"
#include "app/services/mapping/scanner_advice.h"
#include "core/cloud/labels.h"
#include "core/event/cloud_sample.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "core/mapping/live/scan_doubts.h"
#include "core/mapping/placement/placement_format.h"
#include "core/mapping/plane/plane_scan.h"

namespace leitstand {
namespace {

/// A plane laser begins the map this long after its first turn, if nothing came from the 3D scanners of
/// files.
constexpr std::chrono::seconds ScannerWait(20);
constexpr double AboutARobot = 0.1;  ///< points this close to its corners may be of a robot, too [m]

bool sameFix(const std::optional<RobotFix>& a, const RobotFix& b) {
    return a && a->stamp == b.stamp && a->doubts == b.doubts && a->certainty == b.certainty &&
           a->part == b.part && a->baseInMap.matrix() == b.baseInMap.matrix();
}

}  // namespace

MappedRobot::MappedRobot(const RobotDescription& description, const std::string& station)
    : poses(description),
      tracker(description.name),
      laser(tracker, station),
      mapping(description),
      scanner(mappingSensor(description)),
      planeLaser(planeLaserOf(description)) {
    // Cutters must know the motion before the first slice.
    for (const StreamDescription& stream : description.streams) {
        if (mapping.compares(stream.topic) || stream.topic == planeLaser)
            cutters.try_emplace(stream.topic, description.name);
    }
}

MappedRobots::MappedRobots(MappingContext& context, const std::vector<RobotDescription>& robots,
                           const std::string& station, SeesByLaser sees)
    : m_context(context), m_descriptions(robots), m_sees(std::move(sees)) {
    for (const RobotDescription& robot : m_descriptions) {
        m_robots.try_emplace(robot.name, robot, station).first->second.laser.setCrop(context.crop);
        context.mapper.setBody(robot.name, {robot.footprint, robot.height});
    }
}

bool MappedRobots::isOfOurs(const Event& event) const {
    const bool wanted = event.sample.is<OdometrySample>() || event.sample.is<ImuSample>() ||
                        event.sample.is<CloudSample>() || event.sample.is<RangesSample>() ||
                        event.role == StreamRole::StaticTransforms;
    const auto* clock = event.sample.as<ClockOffsetSample>();
    return (wanted || clock != nullptr) && contains(clock != nullptr ? clock->robot : event.robot);
}

void MappedRobots::add(const Event& event) {
    if (const auto* clock = event.sample.as<ClockOffsetSample>()) {
        m_robots.at(clock->robot).ahead = clock->ahead;
        return;
    }
    MappedRobot& robot = m_robots.at(event.robot);
    if (robot.mapping.compares() && !robot.mapsByPlane) m_scanners.insert(event.robot);
    if (event.role == StreamRole::StaticTransforms) {
        robot.poses.add(event);
    } else if (const auto* odometry = event.sample.as<OdometrySample>()) {
        for (auto& [topic, cutter] : robot.cutters) cutter.add(*odometry, event.received);
        robot.tracker.add(*odometry, event.received);
    } else if (const auto* imu = event.sample.as<ImuSample>()) {
        const Pose unit = robot.poses.inBase(event.sensor, imu->header.frame);
        for (auto& [topic, cutter] : robot.cutters) cutter.add(*imu, unit, event.received);
        robot.tracker.add(*imu, unit, event.received);
    } else if (const auto* cloud = event.sample.as<CloudSample>()) {
        const Pose sensor = robot.poses.inBase(event.sensor, cloud->header.frame);
        robot.sendsClouds = true;
        if (robot.mapsByPlane) return;
        if (!isOfMap(robot, event, *cloud)) return;
        if (!robot.poses.isOfScanner(cloud->header.frame)) robot.scanner.clear();
        CloudSample corrected = *cloud;
        if (corrected.header.stamp == Time{}) corrected.header.stamp = event.received;
        robot.poses.correctionOf(event.sensor, cloud->header.frame).correct(corrected);
        robot.cutters.try_emplace(event.topic, event.robot)
            .first->second.add(std::move(corrected), sensor, event.received);
    } else if (const auto* ranges = event.sample.as<RangesSample>()) {
        const Pose laser = robot.poses.inBase(event.sensor, ranges->header.frame);
        const bool level = isLevel(laser);
        if (level && robot.mapping.compares(event.topic))
            (void)isOfMap(robot, event, cloudOf(*ranges, laser));
        const bool maps = level && mapsByPlane(robot, event);
        if (!maps && m_context.mapper.fix(event.robot)) return robot.laser.rest();  // its 3D scans show more
        RangesSample stamped = *ranges;
        if (stamped.header.stamp == Time{}) stamped.header.stamp = event.received;
        if (maps)
            return robot.cutters.at(event.topic)
                .add(cloudOf(stamped, laser), uprightLaser(laser), event.received);
        m_sees(event.robot, robot, laserView(stamped, laser, robot.tracker.motion()), event.received);
    }
}

bool MappedRobots::isOfMap(MappedRobot& robot, const Event& event, const CloudSample& cloud) {
    const bool known = !robot.mapping.chosen().empty();
    const bool maps = robot.mapping.takes(event.topic, cloud, event.received);
    if (!known && !robot.mapping.chosen().empty()) mapWith(event.robot, robot.mapping.chosen());
    return maps;
}

bool MappedRobots::mapsByPlane(MappedRobot& robot, const Event& event) {
    if (event.topic != robot.planeLaser) return false;
    if (!robot.planeSince) robot.planeSince = event.received;
    if (!robot.mapsByPlane && beginsByPlane(robot, event)) {
        robot.mapsByPlane = true;
        m_scanners.erase(event.robot);
        if (m_context.listener.onMapsWith) m_context.listener.onMapsWith(event.robot, event.topic);
    }
    return robot.mapsByPlane;
}

bool MappedRobots::beginsByPlane(const MappedRobot& robot, const Event& event) const {
    bool named = false, scanned = false;  // by its file; by any 3D scanner
    for (const RobotDescription& one : m_descriptions) {
        scanned = scanned || one.stream(StreamRole::Points) != nullptr;
        for (const StreamDescription& stream : one.streams)
            named = named || (one.name == event.robot && stream.topic == event.topic && stream.maps);
    }
    if (named) return robot.mapping.chosen().empty() || robot.mapping.chosen() == event.topic;
    if (robot.sendsClouds) return false;  // isOfMap() compares them with the laser
    const bool others = std::any_of(m_scanners.begin(), m_scanners.end(),
                                    [&](const std::string& one) { return one != event.robot; });
    if (others || (scanned && event.received - *robot.planeSince < ScannerWait)) return false;
    const auto& map = m_context.map;
    return !map || std::none_of(map->scans.begin(), map->scans.end(),
                                [](const LiveKeyScan& scan) { return leavesPlane(scan.scan->points); });
}

void MappedRobots::mapWith(const std::string& name, const std::string& topic) {
    MappedRobot& robot = m_robots.at(name);
    robot.mapping.choose(topic);
    robot.cutters.try_emplace(topic, name);
    for (auto& [other, cutter] : robot.cutters)
        if (other != topic) (void)cutter.finish();  // nothing that another scanner began enters any more
    for (const RobotDescription& description : m_descriptions) {
        if (description.name != name) continue;
        for (const StreamDescription& stream : description.streams) {
            if (stream.topic != topic) continue;
            const bool plane = stream.role == StreamRole::Ranges;
            robot.scanner = plane ? std::string() : stream.sensor;
            robot.mapsByPlane = plane;
            if (!plane) continue;
            robot.planeLaser = topic;
            m_scanners.erase(name);
        }
    }
    if (robot.mapping.hasChoice() && m_context.listener.onMapsWith)
        m_context.listener.onMapsWith(name, topic);
}

std::optional<Time> MappedRobots::due() const {
    std::optional<Time> first;
    for (const auto& [name, robot] : m_robots) {
        for (const auto& [topic, cutter] : robot.cutters) {
            const auto one = cutter.due();
            if (one && (!first || *one < *first)) first = one;
        }
    }
    return first;
}

std::vector<Disc> MappedRobots::othersThan(const MappedRobot& robot, bool certain) const {
    std::vector<Disc> others;
    for (const RobotDescription& description : m_descriptions) {
        const MappedRobot& other = m_robots.at(description.name);
        if (&other == &robot || !other.tracker.placed() || (certain && !other.tracker.now().certain))
            continue;
        Disc disc{other.tracker.now().baseInMap.translation().head<2>(), 0.0};
        for (const Eigen::Vector2d& corner : description.footprint)
            disc.radius = std::max(disc.radius, corner.norm() + AboutARobot);
        others.push_back(disc);
    }
    return others;
}

void MappedRobots::followFixes() {
    for (auto& [name, robot] : m_robots) {
        const auto fix = m_context.mapper.fix(name);
        if (!fix || sameFix(robot.followed, *fix)) continue;
        robot.followed = fix;
        const bool certain = fix->doubts == 0;
        robot.tracker.correct({fix->stamp, fix->baseInMap, certain ? fix->certainty : 0.0, certain,
                               !certain         ? inWords(fix->doubts)
                               : fix->part != 0 ? logged(placement_format::OwnPart)
                                                : logged(placement_format::FitsMap)});
    }
}

bool scansMoved(const LiveMapPtr& before, const LiveMap& after) {
    if (!before) return false;
    // Scans are only ever added, at the end.
    for (std::size_t i = 0; i < before->scans.size() && i < after.scans.size(); ++i) {
        const ScanPose &was = before->scans[i].pose, &is = after.scans[i].pose;
        const bool aside = was.trust == ScanTrust::SetAside, asideNow = is.trust == ScanTrust::SetAside;
        if (aside != asideNow || was.scanInMap.matrix() != is.scanInMap.matrix()) return true;
    }
    return false;
}

void MappedRobots::layTrails() {
    for (auto& [name, robot] : m_robots) {
        std::vector<TrailAnchor> anchors;
        for (const LiveKeyScan& one : m_context.map->scans) {
            const Scan& scan = *one.scan;
            if (scan.robot != name || !scan.hasOdometry || one.odometryFrame < 0) continue;
            if (one.pose.trust == ScanTrust::SetAside) continue;
            anchors.push_back(
                {scan.end, one.odometryFrame, one.pose.scanInMap * scan.sensorInOdom.inverse()});
        }
        if (!anchors.empty()) robot.tracker.layTrail(anchors);
    }
}

void MappedRobots::carryAlong() {
    if (!m_context.map) return;
    const MovedPlaces places(*m_context.map, *m_context.mapper.map());
    if (!places.any()) return;
    for (auto& [name, robot] : m_robots) {
        if (!robot.tracker.placed() || m_context.mapper.fix(name)) continue;
        robot.tracker.move(places);
        robot.laser.mapMoved();
    }
}

void MappedRobots::scanReceived(const std::string& robot, Time received) {
    const std::lock_guard lock(m_mutex);
    m_received[robot] = received;
}

void MappedRobots::matched(const std::string& name, Time now) {
    m_robots.at(name).matched = now;
    const std::lock_guard lock(m_mutex);
    m_received.erase(name);
}

void MappedRobots::matchedElsewhere() {
    for (auto& [name, robot] : m_robots) robot.matched.reset();
}

void MappedRobots::publish() {
    auto places = std::make_shared<RobotsInMap>();
    for (const auto& [name, robot] : m_robots) {
        places->push_back(robot.tracker.now());
        places->back().matched = robot.matched;
        if (robot.followed) places->back().spinning = robot.followed->spinningAt(places->back().stamp);
    }
    const std::lock_guard lock(m_mutex);
    for (RobotInMap& place : *places) {
        const auto scanReceived = m_received.find(place.robot);
        if (scanReceived != m_received.end()) place.matched = scanReceived->second;
    }
    m_places = std::move(places);
}

RobotsInMapPtr MappedRobots::inMap() const {
    const std::lock_guard lock(m_mutex);
    return m_places;
}

}  // namespace leitstand
