// A building of two storeys, explored by both robots as their operator sends them, within half an hour of
// theirs.
#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/mapping/building_sets.h"
#include "tests/simulation/mapping/building_tour.h"
#include "tests/simulation/mapping/toured_in_world.h"

namespace leitstand::simulation::test {
namespace {

constexpr double HalfAnHour = 1800.0;  ///< [s]

/// What Kurt3D said and where it truly was while both robots went through a building.
struct Explored {
    RecordedDrive drive;
    double seconds = 0.0;
    std::size_t places = 0, reached = 0, pulledBack = 0;  ///< Kurt3D's
    double highest = 0.0;                                 ///< that it got to [m]
};

/// Both robots in a building, each on its tour.
class Exploring {
public:
    Exploring(const Building& building, std::uint64_t seed)
        : m_world(building.arena, seed),
          m_kurts(m_touredKurt, roomsInOrder(building, 2)),
          m_crawlers(m_touredCrawler, theOtherWay(roomsInOrder(building, 1))) {
        result.drive.arena = building.arena;
        result.drive.robot = m_kurt.description();
        m_was = m_kurt.state().baseInArena.translation();
    }
    void run(double longest) {
        passes(3.0);  // robots stand at first
        const double begin = m_world.seconds();
        int minutes = 0;
        while (m_world.seconds() - begin < longest && !(m_kurts.isOver() && m_crawlers.isOver())) {
            m_touredKurt.receive(passes(0.1));
            m_kurts.look();
            m_touredCrawler.receive(m_crawler.reported());
            m_crawlers.look();
            m_crawler.forget();
            if (m_world.seconds() - begin < 60.0 * (minutes + 1)) continue;
            std::printf("%3d min, %4.0f m: Kurt3D %s\n                the Crawler %s\n", ++minutes,
                        result.drive.way, m_kurts.doing().c_str(), m_crawlers.doing().c_str());
            std::fflush(stdout);
        }
        result.seconds = m_world.seconds() - begin;
        result.places = m_kurts.places();
        result.reached = m_kurts.reached();
        result.pulledBack = m_kurts.pulledBack();
    }

    Explored result;

private:
    static std::vector<Eigen::Vector3d> theOtherWay(std::vector<Eigen::Vector3d> places) {
        std::reverse(places.begin(), places.end());
        return places;
    }
    /// Returns what Kurt3D said meanwhile.
    std::vector<HardwareSample> passes(double seconds) {
        std::vector<HardwareSample> reported;
        for (int i = 0; i < static_cast<int>(seconds * 100.0 + 0.5); ++i) {
            pass(m_world, {&m_kurt, &m_crawler}, 0.01);
            const Pose& base = m_kurt.state().baseInArena;
            result.drive.truth.add(m_world.now(), base);
            result.drive.way += (base.translation() - m_was).norm();
            result.highest = std::max(result.highest, base.translation().z());
            m_was = base.translation();
            for (const HardwareSample& sample : m_kurt.reported()) {
                reported.push_back(sample);
                if (isForMapping(sample)) result.drive.received.push_back({m_world.now(), sample});
            }
            m_kurt.forget();
        }
        return reported;
    }

    World m_world;
    OperatedRobot m_kurt{m_world, "kurt3d"}, m_crawler{m_world, "crawler"};
    TouredInWorld m_touredKurt{m_kurt}, m_touredCrawler{m_crawler};
    BuildingTour m_kurts, m_crawlers;
    Eigen::Vector3d m_was = Eigen::Vector3d::Zero();
};

TEST(ExploredBuildingLong, TwoStoreysInHalfAnHour) {
    const std::uint64_t seed = measuredSeed();
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    settings.storeys = 2;
    const Building building = std::move(generateBuilding(settings, seed)).value();
    Exploring exploring(building, seed);
    exploring.run(HalfAnHour);
    const Explored& made = exploring.result;
    LiveSettings mapping;
    mapping.loops.on = true;
    const MappedDrive map = mapped(made.drive, cutScans(made.drive), mapping);
    const BuildingRow row = rowOf(building, made.drive, map);
    std::printf(
        "building %llu: %.0f s, %.0f m, %zu of %zu places, %zu times pulled back; %zu scans, %zu key scans, "
        "odometry %.2f m, %d uncertain, met itself %zu times\n         ATE    seam   surfaces [m]  z   "
        "[degrees]\n",
        static_cast<unsigned long long>(seed), made.seconds, row.way, made.reached, made.places,
        made.pulledBack, row.scans, row.keyScans, row.odometry, row.uncertain, row.solves);
    print("entry", row.entry);
    print("final", row.final);
    std::printf("    wanted   0.050   0.040; finds 0.050\n");
    for (const double error : row.finds) std::printf("    a find is %.3f m off\n", error);
    EXPECT_GT(made.highest, 0.9 * building.ways.storeyHeight) << "up the ramp";
    EXPECT_GE(static_cast<double>(made.reached), 0.75 * static_cast<double>(made.places));
    EXPECT_LE(row.final.ate, 0.05);
    EXPECT_LE(row.uncertain, 0.15 * static_cast<double>(row.scans));
    EXPECT_GE(row.finds.size(), 4U);
    for (const double error : row.finds) EXPECT_LE(error, 0.05);
    EXPECT_LE(row.final.seam, 0.10) << "not as good as it is to be";
}

}  // namespace
}  // namespace leitstand::simulation::test
