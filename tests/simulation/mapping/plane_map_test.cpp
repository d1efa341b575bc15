// Maps that a robot with a plane laser makes of buildings.
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/simulation/mapping/building_sets.h"

namespace leitstand::simulation::test {
namespace {

/// A better laser than that of a TurtleBot 4: 30 m, deviation 1 cm + 0.2 % of the range.
PlaneLaserSettings farLaser() {
    PlaneLaserSettings laser = rplidarA1();
    laser.laser.farthest = 30.0;
    laser.laser.deviation = 0.01;
    laser.laser.deviationOfRange = 0.002;
    return laser;
}

/// A drive, and what its map must come to [m].
struct PlaneSet {
    const char* name;
    bool eight, smooth, troubles;
    PlaneLaserSettings laser;
    double ate, seam, surfaces;
};

std::vector<PlaneSet> planeSets() {
    return {{"ring", false, false, false, rplidarA1(), 0.10, 0.06, 0.06},
            {"eight", true, false, false, rplidarA1(), 0.10, 0.25, 0.06},
            {"bare", false, true, false, rplidarA1(), 0.10, 0.08, 0.07},
            {"far", true, false, false, farLaser(), 0.03, 0.10, 0.03},
            {"troubles", false, false, true, rplidarA1(), 0.10, 0.06, 0.06}};
}

BuildingRow mappedBy(const PlaneSet& set, const BuildingSettings& settings, std::uint64_t seed) {
    const Building building = std::move(generateBuilding(settings, seed)).value();
    ScriptSettings script;
    script.seed = seed;
    script.speed = 0.3;
    if (set.eight) script.longest = 357.0;
    const auto route = set.eight ? eightRoute(building.ways, 4) : ringRoute(building.ways);
    const BuildingRow row = driven(building, route, script, set.laser);
    std::printf(
        "%s %llu: %zu scans, %zu key scans, %.0f m, odometry %.2f m, %d uncertain, %.1f ms a scan, "
        "longest %.0f, met itself %zu times, %d links contradicted\n"
        "           ATE    seam   surfaces [m]  z   [degrees]\n",
        set.name, static_cast<unsigned long long>(seed), row.scans, row.keyScans, row.way, row.odometry,
        row.uncertain, 1e3 * row.median, 1e3 * row.longest, row.solves, row.contradicted);
    print("entry", row.entry);
    print("final", row.final);
    return row;
}

void expectWithin(const PlaneSet& set, const BuildingRow& row) {
    EXPECT_LE(row.final.ate, set.ate);
    EXPECT_LE(row.final.seam, set.seam);
    EXPECT_LE(row.final.surfaces, set.surfaces);
    EXPECT_LE(row.uncertain, static_cast<int>(row.scans / 100));
    EXPECT_GE(row.solves, 1U) << "the map meets itself";
    EXPECT_LE(row.median, 0.010);
}

TEST(PlaneMap, ALapOfASmallBuildingIsMappedByAPlaneLaser) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    settings.troubles = false;
    const PlaneSet set = planeSets().front();
    expectWithin(set, mappedBy(set, settings, 7));
}

class PlaneMapLong : public testing::TestWithParam<std::size_t> {};

TEST_P(PlaneMapLong, ABuildingIsMappedByAPlaneLaser) {
    const PlaneSet set = planeSets()[GetParam()];
    BuildingSettings settings;
    settings.smooth = set.smooth;
    settings.troubles = set.troubles;
    const BuildingRow row = mappedBy(set, settings, measuredSeed());
    EXPECT_GT(row.odometry, 0.4) << "the drift that mapping takes out";
    expectWithin(set, row);
}

INSTANTIATE_TEST_SUITE_P(Buildings, PlaneMapLong, testing::Range(std::size_t{0}, planeSets().size()),
                         [](const auto& one) { return std::string(planeSets()[one.param].name); });

}  // namespace
}  // namespace leitstand::simulation::test
