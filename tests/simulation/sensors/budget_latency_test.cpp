#include <ctime>

#include <gtest/gtest.h>

#include "core/io/robot/robot_file.h"
#include "robots/simulation/simulated_hardware.h"
#include "tests/simulation/sensors/room.h"

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
    return readRobot(std::string(LEITSTAND_SOURCE_DIR) + "/resources/robots/" + name + ".yaml").value();
}

/// A maze of walls, as far as light and rays care.
std::unique_ptr<World> maze() {
    RoomBuilder room;
    room.walls(6, 6, 1.2);
    const int wood = room.surface(Material::Plywood);
    for (int i = 0; i < 40; ++i) {
        const double x = -5.4 + 1.2 * (i % 10), y = -4.2 + 2.4 * (i / 10);
        if (i % 3 == 0) {
            room.box(wood, {x, y, 0.0}, {x + 1.2, y + 0.05, 1.2});
        } else {
            room.box(wood, {x, y, 0.0}, {x + 0.05, y + 1.2, 1.2});
        }
    }
    return room.world();
}

TEST(SensorBudgetLatency, BothRobotsWithAllSensorsTakeLessThanACore) {
    const auto world = maze();
    const RobotDescription kurt3d = shipped("kurt3d"), crawler = shipped("crawler");
    const int first = world->addRobot(kurt3dBody(), poseFrom({0.2, -0.6, 0}, 0, 0, 0.3));
    const int second = world->addRobot(crawlerBody(), poseFrom({0.2, 0.9, 0}, 0, 0, 0));
    const auto kurt3dHardware = makeKurt3dHardware(*world, first, kurt3d);
    const auto crawlerHardware = makeCrawlerHardware(*world, second, crawler);
    kurt3dHardware->setMotors(0.2, 0.3);
    crawlerHardware->setMotors(0.3, 0.2);
    (void)kurt3dHardware->take();
    (void)crawlerHardware->take();
    double ofWorld = 0.0, ofKurt3d = 0.0, ofCrawler = 0.0;
    constexpr double Seconds = 5.0;
    const Time end = world->now() + std::chrono::seconds(5);
    while (world->now() < end) {
        const double begin = processorTime();
        world->advance(20ms);
        const double moved = processorTime();
        (void)kurt3dHardware->take();
        const double taken = processorTime();
        (void)crawlerHardware->take();
        ofWorld += moved - begin;
        ofKurt3d += taken - moved;
        ofCrawler += processorTime() - taken;
    }
    std::printf("share of a core: world %.2f, Kurt3D's sensors %.2f, Crawler's sensors %.2f\n",
                ofWorld / Seconds, ofKurt3d / Seconds, ofCrawler / Seconds);
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LT((ofWorld + ofKurt3d + ofCrawler) / Seconds, 1.0);
#else
    GTEST_SKIP() << "unoptimised or checked at every step: the share of a core means nothing";
#endif
}

}  // namespace
}  // namespace leitstand::simulation::test
