#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <iostream>

#include <QTest>

#include <gtest/gtest.h>

#include "tests/widgets/map_live/live_map.h"
#include "tests/widgets/map_view/maps.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// Pictures a second, what a tick costs the GUI thread [ms], and cores that all threads use, while a robot
/// drives through the map.
struct Driven {
    double rate = 0.0, worstTick = 0.0, cores = 0.0;
};

Driven drive(ShownView& view, double length) {
    RobotMark robot = kurt3d(onFloor(0, 0, 0));
    int pictures = 0;
    const auto counting = QObject::connect(&*view, &MapView::drawn, &*view, [&pictures] { ++pictures; });
    Driven driven;
    const std::clock_t used = std::clock();
    const auto start = Clock::now();
    for (double t = 0.0; t < length; t = Seconds(Clock::now() - start).count()) {
        robot.baseInMap = onFloor(0.5 * t, 0.1 * t, 0.4 * t);
        const auto before = Clock::now();
        view->setRobots({robot});
        driven.worstTick = std::max(driven.worstTick, 1e3 * Seconds(Clock::now() - before).count());
        QTest::qWait(33);
    }
    const double seconds = Seconds(Clock::now() - start).count();
    driven.rate = pictures / seconds;
    driven.cores = static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / seconds;
    QObject::disconnect(counting);
    return driven;
}

/// Scans of one room each, 5 million points in all.
class NavigationLatency : public testing::TestWithParam<std::size_t> {};

TEST_P(NavigationLatency, FiveMillionPointsFollowARobotAtTenPicturesASecond) {
    MapViewSettings settings;
    settings.follow = MapFollow::Behind;
    ShownView view(largeMap(5'000'000, 5'000'000 / GetParam()), settings, {1280, 800});
    view->setRobots({kurt3d(onFloor(0, 0, 0))});
    EXPECT_TRUE(QTest::qWaitFor([&] { return view->settled(); }, 120'000));
    (void)drive(view, 3.0);  // learns how much can be drawn
    const Driven following = drive(view, 4.0);
    const auto stood = Clock::now();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view->settled(); }, 120'000));
    const double whole = Seconds(Clock::now() - stood).count();
    std::cout << "5 M points in " << GetParam() << " scans, following a robot: " << following.rate
              << " pictures/s, a tick takes at most " << following.worstTick << " ms of the GUI thread, "
              << following.cores << " cores; all points are there after " << whole << " s\n";
    EXPECT_GE(following.rate, 10.0);
    EXPECT_LT(following.worstTick, 20.0);
    view->setSettings({});
    view.settle();
    const Driven standing = drive(view, 2.0);
    std::cout << "a robot moves under a camera that stands: " << standing.rate
              << " pictures of the points/s, a tick takes at most " << standing.worstTick << " ms\n";
    EXPECT_LT(standing.rate, 1.0) << "only robots are painted again";
}

INSTANTIATE_TEST_SUITE_P(Scans, NavigationLatency, testing::Values(100, 1000));

}  // namespace
}  // namespace leitstand::test
