#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/mapping/motion/scan_cutter.h"
#include "core/mapping/placement/laser_robot.h"
#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/world/operated_robot.h"

namespace leitstand::simulation::test {

class BuildingTour;
class TouredInWorld;

/// Kurt3D, which maps an arena, and the Crawler, which is placed in its map.
class RobotPair {
public:
    /// @p wrongSlot: so far is the Crawler's start from the slot that the settings tell.
    RobotPair(std::uint64_t yellow, const Pose& wrongSlot);
    /// In a building, which both go through on their tours.
    RobotPair(const Building& building, std::uint64_t seed);
    ~RobotPair();

    /// Both stand, or go as told, each turning away from what is ahead of it.
    void pass(double seconds, bool kurtDrives, bool crawlerDrives);
    void tour(double seconds);

    [[nodiscard]] const RobotInMap& crawler() const { return m_tracker.now(); }
    /// The Crawler's base_link in the map, truly.
    [[nodiscard]] Pose truth() const;
    /// ... less where the map has it: distance [m] and heading [rad].
    [[nodiscard]] double off() const;
    [[nodiscard]] double turned() const;
    /// How far the Crawler is from where it would be in the map as Kurt3D's nearest scan lies in it, whose
    /// own error is not the Crawler's [m].
    [[nodiscard]] double offNearby() const;
    [[nodiscard]] RobotPlaceSample place(const Pose& baseInMap);

    std::vector<RobotPlaceSample> places;  ///< all that came of the Crawler
    double way = 0.0;                      ///< that the Crawler drove [m]
    double seconds = 0.0;                  ///< that following took, all in all [s]
    int views = 0;
    bool leavesOut = true;       ///< whether the Crawler is kept out of Kurt3D's scans
    int bodyPoints = 0;          ///< of key scans since the Crawler was placed: truly on it
    bool sightings = false;      ///< whether the Crawler is looked for where Kurt3D sees it
    std::vector<SeenBody> seen;  ///< newest
    double sightingSeconds = 0.0;

private:
    void receive();
    [[nodiscard]] int onCrawler(const KeyScanSample& key) const;
    [[nodiscard]] std::vector<Disc> kurtOnMap() const;
    void begin(const Pose& wrongSlot, std::uint64_t seed);
    void step();
    void steer(OperatedRobot& robot, bool drives, double speed);

    std::unique_ptr<World> m_world;
    std::unique_ptr<OperatedRobot> m_kurt, m_crawler;
    std::unique_ptr<TouredInWorld> m_touredKurt, m_touredCrawler;
    std::unique_ptr<BuildingTour> m_kurtsTour, m_crawlersTour;
    Pose m_firstInArena = Pose::Identity();  ///< Kurt3D's scanner when it made the map
    std::optional<Pose> m_mapInArena;
    Pose m_kurtBegan = Pose::Identity();  ///< in the map
    ScanCutter m_cutter{"kurt3d"};
    LiveMapper m_mapper{"test", {}};
    LiveMapPtr m_map;
    std::map<std::uint64_t, Pose> m_takenAt;  ///< base_link in the arena, by key scan
    RobotTracker m_tracker{"crawler"};
    std::unique_ptr<LaserRobot> m_laser;
    Eigen::Vector2d m_last = Eigen::Vector2d::Zero();
    std::optional<RangesSample> m_ahead;  ///< newest of the Crawler's laser
    double m_turn[2] = {0.0, 0.0};        ///< that a robot is at, to get away [rad/s]
};

}  // namespace leitstand::simulation::test
