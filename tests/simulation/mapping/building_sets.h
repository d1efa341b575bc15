#pragma once

#include <vector>

#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/mapping/mapped_drive.h"
#include "tests/simulation/mapping/measured_seed.h"
#include "tests/simulation/mapping/scripted_drive.h"

namespace leitstand::simulation::test {

// Ways through a building.

/// Once around the ring and a little more, so that the way meets itself: @p laps of it.
[[nodiscard]] std::vector<Eigen::Vector3d> ringRoute(const BuildingWays& ways, double laps = 1.03);
/// The western half of the ring, then the eastern one, through the cross corridor each time, again and again.
[[nodiscard]] std::vector<Eigen::Vector3d> eightRoute(const BuildingWays& ways, int loops);
/// Around the ring of the ground, up the ramp, around the ring above, and down again.
[[nodiscard]] std::vector<Eigen::Vector3d> storeysRoute(const BuildingWays& ways);

/// How well a drive through a building was mapped.
struct BuildingResult {
    double ate = 0.0;       ///< root mean square of positions after rigid alignment [m]
    double height = 0.0;    ///< of that, along z [m]
    double angle = 0.0;     ///< likewise of attitudes [rad]
    double seam = 0.0;      ///< worstSeam() [m]: final, of key scans that count; entry, of all scans
    double surfaces = 0.0;  ///< root mean square distance of points within 6 m from true surfaces [m]
};
struct BuildingRow {
    std::size_t scans = 0, keyScans = 0;
    double way = 0.0;                    ///< [m]
    double odometry = 0.0;               ///< its trajectory error [m]
    int uncertain = 0;                   ///< scans, as they entered
    BuildingResult entry;                ///< scans where they were put as they came
    BuildingResult final;                ///< key scans where the map has them at the end
    double median = 0.0, longest = 0.0;  ///< processor time of a scan [s]
    double early = 0.0, late = 0.0;      ///< median, about 100 and about 1,000 key scans; 0: not so many
    double beside = 0.0;                 ///< cores, over the drive, that loops and solving take together
    double casting = 0.0;                ///< time that making the scans took [s]
    ScannerCorrection correction;        ///< MappedDrive::correction
    int corrections = 0;                 ///< likewise
    std::size_t solves = 0;              ///< times that the map met itself
    int contradicted = 0;                ///< links of loops that others spoke against
    std::vector<double> finds;           ///< findErrors()
    double solving = 0.0,
           settling = 0.0;  ///< processor time of the longest, apart and on the mapper's thread [s]
};

/// Prints @p result as a line of a table.
void print(const char* how, const BuildingResult& result);

/// What @p mapped, made of @p drive in @p building, comes to.
[[nodiscard]] BuildingRow rowOf(const Building& building, const RecordedDrive& drive,
                                const MappedDrive& mapped);

/// Drives along @p corners in @p building, maps it as LiveMapper does with @p mapping, and compares with the
/// truth. What the map advises about the scanner is used.
[[nodiscard]] BuildingRow driven(const Building& building, const std::vector<Eigen::Vector3d>& corners,
                                 const ScriptSettings& script, const LiveSettings& mapping = {});

/// The same for a TurtleBot 4, which maps with the plane laser @p laser.
[[nodiscard]] BuildingRow driven(const Building& building, const std::vector<Eigen::Vector3d>& corners,
                                 const ScriptSettings& script, const PlaneLaserSettings& laser,
                                 const LiveSettings& mapping = {});

}  // namespace leitstand::simulation::test
