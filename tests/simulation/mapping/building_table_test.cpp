#include <cstdio>
#include <limits>

#include <gtest/gtest.h>

#include "tests/simulation/mapping/building_sets.h"

namespace leitstand::simulation::test {
namespace {

constexpr double Any = std::numeric_limits<double>::infinity();

/// What the final poses of a set must come to.
struct Bounds {
    double ate = Any, seam = Any;  ///< [m]
    double uncertain = Any;        ///< share of all scans
    double surfaces = Any;         ///< [m]
};

enum class Route { Ring, Eight, Kilometre, Storeys };

/// A line of the table.
struct Set {
    const char* name;
    Route route = Route::Ring;
    bool smooth = false, twins = false, troubles = false;
    bool bent = false;  ///< turns are bent by odometry's drift, too
    SensorErrors sensor = {};
    Bounds today = {};   ///< what holds now
    Bounds wanted = {};  ///< what is to hold: told beside each row, asked for by who mends the mapper
};

// What is wanted where no other bound stands beside a set: points within 6 m from true surfaces.
constexpr double WantedSurfaces = 0.03;

std::vector<Set> sets() {
    std::vector<Set> all(11);
    all[0] = {.name = "ring", .today = {0.02, 0.03, 0.0, 0.03}, .wanted = {0.02, 0.03, 0.0, WantedSurfaces}};
    all[1] = {.name = "eight",
              .route = Route::Eight,
              .today = {0.03, 0.03, 0.01, 0.03},
              .wanted = {0.03, 0.03, 0.01, WantedSurfaces}};
    all[2] = {.name = "bare",
              .smooth = true,
              .today = {0.05, 0.05, 0.01, 0.03},
              .wanted = {0.05, 0.05, Any, WantedSurfaces}};
    all[3] = {.name = "real",
              .sensor = realScanner(),
              .today = {0.05, 0.03, 0.01, 0.03},
              .wanted = {0.05, 0.03, Any, WantedSurfaces}};
    all[4] = {.name = "worse",
              .sensor = worseScanner(),
              .today = {0.06, 0.04, 0.01, 0.03},
              .wanted = {0.06, 0.04, Any, WantedSurfaces}};
    all[5] = {.name = "storeys",
              .route = Route::Storeys,
              .today = {0.06, 0.04, 0.01, 0.03},
              .wanted = {0.06, 0.04, Any, WantedSurfaces}};
    all[6] = {.name = "twins",
              .twins = true,
              .today = {0.02, 0.03, 0.01, 0.03},
              .wanted = {0.02, 0.03, Any, WantedSurfaces}};
    all[7] = {.name = "troubles",
              .troubles = true,
              .today = {0.02, 0.03, 0.01, 0.03},
              .wanted = {0.02, 0.03, Any, WantedSurfaces}};
    all[8] = {.name = "bent",
              .bent = true,
              .today = {0.03, 0.03, 0.01, 0.03},
              .wanted = {0.05, 0.03, Any, WantedSurfaces}};
    all[9] = {.name = "rough",  // as real, and it sits as somebody put it there
              .sensor = withRoughMount(realScanner()),
              .today = {0.05, 0.03, 0.01, 0.03},
              .wanted = {0.05, 0.03, Any, WantedSurfaces}};
    all[10] = {.name = "kilometre",
               .route = Route::Kilometre,
               .today = {0.03, 0.03, 0.01, 0.03},
               .wanted = {0.03, 0.03, 0.01, WantedSurfaces}};
    return all;
}

BuildingRow measured(const Set& set, std::uint64_t seed) {
    BuildingSettings settings;
    settings.smooth = set.smooth;
    settings.twins = set.twins;
    settings.troubles = set.troubles;
    settings.storeys = set.route == Route::Storeys ? 2 : 1;
    const Building building = std::move(generateBuilding(settings, seed)).value();
    ScriptSettings script;
    script.seed = seed;
    script.sensor = set.sensor;
    script.driftBendsTurns = set.bent;
    LiveSettings mapping;
    mapping.loops.on = true;
    switch (set.route) {
        case Route::Ring:
            return driven(building, ringRoute(building.ways), script, mapping);
        case Route::Eight:
            script.longest = 357.0;
            return driven(building, eightRoute(building.ways, 4), script, mapping);
        case Route::Kilometre:
            script.longest = 1'000.0;
            return driven(building, eightRoute(building.ways, 12), script, mapping);
        case Route::Storeys:
            break;
    }
    return driven(building, storeysRoute(building.ways), script, mapping);
}

class BuildingTableLong : public testing::TestWithParam<std::size_t> {};

TEST_P(BuildingTableLong, Row) {
    const Set set = sets()[GetParam()];
    const std::uint64_t seed = measuredSeed();
    const BuildingRow row = measured(set, seed);
    std::printf(
        "%s %llu: %zu scans, %zu key scans, %.0f m, odometry %.2f m, %d uncertain, %.0f ms a scan, longest "
        "%.0f, made in %.1f s\n",
        set.name, static_cast<unsigned long long>(seed), row.scans, row.keyScans, row.way, row.odometry,
        row.uncertain, 1e3 * row.median, 1e3 * row.longest, row.casting);
    std::printf(
        "    solved %zu times, %.0f ms at most, settled within %.0f ms, %d links contradicted\n           "
        "ATE    seam   surfaces [m]  z   "
        "[degrees]\n",
        row.solves, 1e3 * row.solving, 1e3 * row.settling, row.contradicted);
    std::printf("    scanner corrected %d times: %.1f cm, roll %.2f, pitch %.2f degrees\n", row.corrections,
                100.0 * row.correction.range, inDegrees(row.correction.roll),
                inDegrees(row.correction.pitch));
    std::printf("    a scan about 100 key scans %.1f ms, about 1,000 %.1f ms; loops and solves %.3f cores\n",
                1e3 * row.early, 1e3 * row.late, row.beside);
    print("entry", row.entry);
    print("final", row.final);
    std::printf("    %-6s %7.3f %7.3f %7.3f, uncertain %.2f of all\n", "wanted", set.wanted.ate,
                set.wanted.seam, set.wanted.surfaces, set.wanted.uncertain);
    EXPECT_GT(row.odometry, 0.5) << "the drift that mapping takes out";
    EXPECT_LE(row.median, 0.015);
    if (set.route == Route::Kilometre) {
        EXPECT_GT(row.late, 0.0);
    }
    if (row.late > 0.0) {
        EXPECT_LE(row.late, 1.1 * row.early);
    }
    EXPECT_LE(row.beside, 0.5);
    EXPECT_LE(row.settling, 0.05) << "scans that come wait for it";
    EXPECT_LE(row.final.ate, set.today.ate);
    EXPECT_LE(row.final.seam, set.today.seam);
    EXPECT_LE(row.final.surfaces, set.today.surfaces);
    EXPECT_LE(row.uncertain, set.today.uncertain * static_cast<double>(row.scans));
}

INSTANTIATE_TEST_SUITE_P(Buildings, BuildingTableLong, testing::Range(std::size_t{0}, sets().size()),
                         [](const auto& one) { return std::string(sets()[one.param].name); });

}  // namespace
}  // namespace leitstand::simulation::test
