#include <ctime>

#include <gtest/gtest.h>

#include "core/io/robot/robot_file.h"
#include "robots/simulation/arena/arena_generator.h"
#include "robots/simulation/simulated_hardware.h"
#include "tests/support/places.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

/// Processor time that this thread took [s].
double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

RobotDescription shipped(const std::string& name) {
    return readRobot(leitstand::test::sourceFolder() + "/resources/robots/" + name + ".yaml").value();
}

/// What a second of the world costs, of a core.
struct Shares {
    double world = 0.0, kurt3d = 0.0, crawler = 0.0;
    [[nodiscard]] double all() const { return world + kurt3d + crawler; }
};

/// Both robots drive with all sensors in the arena of @p grade and @p seed.
Shares shares(Grade grade, std::uint64_t seed) {
    World world(generateArena(grade, seed), seed);
    const RobotDescription kurt3d = shipped("kurt3d"), crawler = shipped("crawler");
    const int first = world.addRobot(kurt3dBody()), second = world.addRobot(crawlerBody());
    const auto kurt3dHardware = makeKurt3dHardware(world, first, kurt3d);
    const auto crawlerHardware = makeCrawlerHardware(world, second, crawler);
    kurt3dHardware->setMotors(0.3, 0.45);
    crawlerHardware->setMotors(0.45, 0.3);
    (void)kurt3dHardware->take();  // measures the light
    (void)crawlerHardware->take();
    Shares shares;
    constexpr double Seconds = 4.0;
    while (world.seconds() < Seconds) {
        const double begin = processorTime();
        world.advance(20ms);
        const double moved = processorTime();
        (void)kurt3dHardware->take();
        const double taken = processorTime();
        (void)crawlerHardware->take();
        shares.world += (moved - begin) / Seconds;
        shares.kurt3d += (taken - moved) / Seconds;
        shares.crawler += (processorTime() - taken) / Seconds;
    }
    return shares;
}

TEST(SensorBudgetLatency, BothRobotsWithAllSensorsTakeLessThanACoreInEveryGrade) {
    for (const Grade grade : {Grade::Yellow, Grade::Orange, Grade::Red}) {
        const Shares of = shares(grade, 7);
        std::printf("%s: share of a core: world %.2f, Kurt3D's sensors %.2f, Crawler's sensors %.2f\n",
                    toString(grade).c_str(), of.world, of.kurt3d, of.crawler);
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        EXPECT_LT(of.all(), 1.0) << toString(grade);
#endif
    }
#if !defined(NDEBUG) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "SKIPPED: unoptimised or checked at every step: the share of a core means nothing";
#endif
}

}  // namespace
}  // namespace leitstand::simulation::test
