#include "tests/simulation/mapping/robot_pair.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/mapping/sighting/other_bodies.h"
#include "robots/simulation/arena/arena_generator.h"
#include "tests/simulation/mapping/building_tour.h"
#include "tests/simulation/mapping/toured_in_world.h"

namespace leitstand::simulation::test {
namespace {

Pose placeOf(const Pose& pose) {
    const FlatPose flat = FlatPose::of(pose);
    return flat.standing(pose.translation().z());
}

/// What is nearest ahead [m], of rays within @p angle to either side of @p towards [rad].
double nearest(const RangesSample& scan, double towards, double angle) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
        const double at = scan.angleMin + scan.angleStep * static_cast<double>(i);
        if (std::abs(at - towards) < angle && std::isfinite(scan.ranges[i]))
            least = std::min(least, double{scan.ranges[i]});
    }
    return least;
}

}  // namespace

RobotPair::RobotPair(std::uint64_t yellow, const Pose& wrongSlot)
    : m_world(std::make_unique<World>(generateArena(Grade::Yellow, yellow), yellow)) {
    begin(wrongSlot, yellow);
}

RobotPair::RobotPair(const Building& building, std::uint64_t seed)
    : m_world(std::make_unique<World>(building.arena, seed)) {
    begin(Pose::Identity(), seed);
    std::vector<Eigen::Vector3d> back = roomsInOrder(building, 1);
    std::reverse(back.begin(), back.end());
    m_touredKurt = std::make_unique<TouredInWorld>(*m_kurt);
    m_touredCrawler = std::make_unique<TouredInWorld>(*m_crawler);
    m_kurtsTour = std::make_unique<BuildingTour>(*m_touredKurt, roomsInOrder(building, 1));
    m_crawlersTour = std::make_unique<BuildingTour>(*m_touredCrawler, std::move(back));
}

RobotPair::~RobotPair() = default;

void RobotPair::begin(const Pose& wrongSlot, std::uint64_t seed) {
    HardwareSettings fitting;
    fitting.seed = seed;
    fitting.cameras = false;
    m_kurt = std::make_unique<OperatedRobot>(*m_world, "kurt3d", fitting);
    m_crawler = std::make_unique<OperatedRobot>(*m_world, "crawler", fitting);
    for (const OperatedRobot* robot : {m_kurt.get(), m_crawler.get()})
        m_mapper.setBody(robot->description().name,
                         {robot->description().footprint, robot->description().height});
    // The Crawler stands where the arena has it: the slot is wrong by as much the other way.
    LocaliserSettings settings;
    const Pose between =
        placeOf(m_kurt->state().baseInArena).inverse() * placeOf(m_crawler->state().baseInArena);
    settings.placement.slotInOther = between * wrongSlot;
    m_laser = std::make_unique<LaserRobot>(m_tracker, "test", settings);
    m_last = m_crawler->state().baseInArena.translation().head<2>();
}

Pose RobotPair::truth() const {
    return m_mapInArena->inverse() * m_crawler->state().baseInArena;
}

double RobotPair::off() const {
    return (truth().translation() - crawler().baseInMap.translation()).head<2>().norm();
}

double RobotPair::offNearby() const {
    const Pose& crawler = m_crawler->state().baseInArena;
    double nearest = std::numeric_limits<double>::infinity(), off = nearest;
    for (const LiveKeyScan& key : m_map->scans) {
        const Pose inArena = m_takenAt.at(key.id) * key.sensorInBase;
        const Pose inScan = inArena.inverse() * crawler;
        if (!key.counts() || inScan.translation().norm() > nearest) continue;
        nearest = inScan.translation().norm();
        const Eigen::Vector3d inMap = key.pose.scanInMap * inScan.translation();
        off = (inMap - this->crawler().baseInMap.translation()).head<2>().norm();
    }
    return off;
}

double RobotPair::turned() const {
    return std::abs(std::remainder(FlatPose::of(truth()).heading - FlatPose::of(crawler().baseInMap).heading,
                                   2.0 * M_PI));
}

std::vector<Disc> RobotPair::kurtOnMap() const {
    if (!m_mapInArena) return {};
    const Pose kurtInMap = m_mapInArena->inverse() * m_kurt->state().baseInArena;
    return {{kurtInMap.translation().head<2>(), 0.45}};
}

int RobotPair::onCrawler(const KeyScanSample& key) const {
    const Pose scanInArena = m_world->baseInArena(m_kurt->number(), key.scan->end) * key.sensorInBase;
    Scan left = *key.scan;
    const RobotBody body{m_crawler->description().footprint, m_crawler->description().height};
    for (Time stamp = key.scan->start; stamp <= key.scan->end; stamp += std::chrono::milliseconds(100))
        leaveOutBody(left, body, m_world->baseInArena(m_crawler->number(), stamp).inverse() * scanInArena,
                     0.02);
    return static_cast<int>(std::count_if(left.points.begin(), left.points.end(),
                                          [](const Eigen::Vector3f& point) { return !point.allFinite(); }));
}

RobotPlaceSample RobotPair::place(const Pose& baseInMap) {
    places.push_back(m_laser->place(baseInMap, m_map, m_world->now()));
    return places.back();
}

void RobotPair::steer(OperatedRobot& robot, bool drives, double speed) {
    if (!drives) return robot.request(0.0);
    double& turn = m_turn[0];
    if (!m_ahead) return robot.request(0.0);
    const double ahead = nearest(*m_ahead, 0.0, degrees(30));
    if (ahead > 0.6 || (turn == 0.0 && ahead > 0.4)) {
        turn = 0.0;
        const double left = std::min(1.0, nearest(*m_ahead, degrees(60), degrees(25))),
                     right = std::min(1.0, nearest(*m_ahead, degrees(-60), degrees(25)));
        return robot.request(speed, 0.8 * (left - right));
    }
    if (turn == 0.0) {
        const bool left =
            nearest(*m_ahead, degrees(75), degrees(30)) > nearest(*m_ahead, degrees(-75), degrees(30));
        turn = left ? 0.7 : -0.7;
    }
    robot.request(0.0, turn);
}

void RobotPair::pass(double seconds, bool kurtDrives, bool crawlerDrives) {
    if (kurtDrives) {
        Sender station;
        station.bytes[0] = 1;
        m_kurt->agent().receive(StreamRole::ModeCommand, ModeCommandSample{{}, "station 1", "explore"},
                                station);
    }
    for (int i = 0; i < static_cast<int>(seconds * 100.0 + 0.5); ++i) {
        steer(*m_crawler, crawlerDrives, 0.25);
        step();
    }
}

void RobotPair::tour(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 100.0 + 0.5); ++i) {
        step();
        if (i % 10 != 0) continue;
        m_kurtsTour->look();
        m_crawlersTour->look();
    }
}

void RobotPair::step() {
    simulation::pass(*m_world, {m_kurt.get(), m_crawler.get()}, 0.01);
    if (m_touredKurt) {
        m_touredKurt->receive(m_kurt->reported());
        m_touredCrawler->receive(m_crawler->reported());
    }
    receive();
    const Eigen::Vector2d here = m_crawler->state().baseInArena.translation().head<2>();
    way += (here - m_last).norm();
    m_last = here;
}

void RobotPair::receive() {
    const Time now = m_world->now();
    const auto& kurt = m_kurt->description().sensors;
    for (const auto& one : m_kurt->all<OdometrySample>()) m_cutter.add(one, now);
    for (const auto& one : m_kurt->all<ImuSample>()) m_cutter.add(one, kurt.at("imu").sensorInBase, now);
    for (const auto& one : m_kurt->all<CloudSample>())
        m_cutter.add(one, kurt.at("scanner").sensorInBase, now);
    m_kurt->forget();
    for (const LiveScan& scan : m_cutter.take(now)) {
        const LiveMapPtr before = m_map;
        const RobotBody crawlersBody{m_crawler->description().footprint, m_crawler->description().height};
        std::vector<PlacedBody> others;
        if (leavesOut) addBodies(others, m_tracker, crawlersBody, scan.scan->start, scan.scan->end);
        const MapUpdate update = m_mapper.add(scan, now, others);
        if (update.keyScan && m_tracker.now().certain) bodyPoints += onCrawler(*update.keyScan);
        if (update.keyScan) {
            m_map = m_mapper.map();
            m_takenAt[update.keyScan->id] = m_world->baseInArena(m_kurt->number(), scan.scan->end);
        }
        if (!m_mapInArena) {
            m_mapInArena = m_world->baseInArena(m_kurt->number(), scan.scan->end) * scan.sensorInBase *
                           update.keyScan->scanInMap.inverse();
            m_kurtBegan = update.localisation.baseInMap;
        }
        if (const auto placed = m_laser->placeBeside(m_kurtBegan, m_map, now, kurtOnMap()))
            places.push_back(*placed);
        if (sightings && update.ready) {
            const LocalMap earlier = before ? localMap(before->scans, update.scanInMap) : LocalMap{};
            const auto start = std::chrono::steady_clock::now();
            seen = seenBodies(*update.ready, update.scanInMap, crawlersBody, earlier);
            if (const auto placed = m_laser->placeSeen(seen, crawlersBody, "Kurt3D", m_map, now, kurtOnMap()))
                places.push_back(*placed);
            sightingSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        }
    }
    const auto& crawler = m_crawler->description().sensors;
    for (const auto& one : m_crawler->all<OdometrySample>()) m_tracker.add(one, now);
    for (const auto& one : m_crawler->all<ImuSample>())
        m_tracker.add(one, crawler.at("imu").sensorInBase, now);
    for (const auto& one : m_crawler->all<RangesSample>()) {
        m_ahead = one;
        const auto begin = std::chrono::steady_clock::now();
        auto view = laserView(one, crawler.at("laser").sensorInBase, m_tracker.motion());
        if (const auto place = m_laser->see(std::move(view), m_map, now, kurtOnMap())) {
            places.push_back(*place);
            this->seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            ++views;
        }
    }
    m_crawler->forget();
}

}  // namespace leitstand::simulation::test
