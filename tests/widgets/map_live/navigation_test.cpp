#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <iostream>
#include <utility>
#include <vector>

#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include "tests/support/latency.h"
#include "tests/widgets/map_live/live_map.h"
#include "tests/widgets/map_view/maps.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// Pictures a second, what the longest tick but one in a hundred costs the GUI thread [ms], and cores that
/// all threads use, while a robot drives through the map.
struct Driven {
    double rate = 0.0, tick = 0.0, cores = 0.0;
};

constexpr double AskedRate = 10.0, LeastRate = AskedRate / Generous;  ///< pictures a second
constexpr double MostTick = 50.0;                                     ///< [ms]

Driven drive(ShownView& view, double length) {
    RobotMark robot = kurt3d(onFloor(0, 0, 0));
    int pictures = 0;
    const auto counting = QObject::connect(&*view, &MapView::drawn, &*view, [&pictures] { ++pictures; });
    Driven driven;
    std::vector<double> ticks;
    const std::clock_t used = std::clock();
    const auto start = Clock::now();
    for (double t = 0.0; t < length; t = Seconds(Clock::now() - start).count()) {
        robot.baseInMap = onFloor(0.5 * t, 0.1 * t, 0.4 * t);
        const auto before = Clock::now();
        view->setRobots({robot});
        ticks.push_back(1e3 * Seconds(Clock::now() - before).count());
        QTest::qWait(33);
    }
    const double seconds = Seconds(Clock::now() - start).count();
    driven.rate = pictures / seconds;
    driven.tick = quantile(std::move(ticks), 0.99);
    driven.cores = static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / seconds;
    QObject::disconnect(counting);
    return driven;
}

/// What the hand does at @p t [s] since it began.
using Hand = std::function<void(MapView& view, double t)>;

/// The same while a hand moves the camera.
Driven navigate(ShownView& view, double length, const Hand& hand) {
    int pictures = 0;
    const auto counting = QObject::connect(&*view, &MapView::drawn, &*view, [&pictures] { ++pictures; });
    Driven moved;
    std::vector<double> ticks;
    const std::clock_t used = std::clock();
    const auto start = Clock::now();
    for (double t = 0.0; t < length; t = Seconds(Clock::now() - start).count()) {
        const auto before = Clock::now();
        hand(*view, t);
        ticks.push_back(1e3 * Seconds(Clock::now() - before).count());
        QTest::qWait(16);  // as a mouse tells
    }
    const double seconds = Seconds(Clock::now() - start).count();
    moved.rate = pictures / seconds;
    moved.tick = quantile(std::move(ticks), 0.99);
    moved.cores = static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / seconds;
    QObject::disconnect(counting);
    return moved;
}

/// Where a hand that draws circles is at @p t [s].
QPointF circling(const MapView& view, double t) {
    return QPointF(view.rect().center()) + 150.0 * QPointF(std::cos(2.0 * t), std::sin(2.0 * t));
}

/// The camera is dragged in circles by @p button.
Driven dragging(ShownView& view, double length, Qt::MouseButton button) {
    QTest::mousePress(&*view, button, {}, circling(*view, 0.0).toPoint());
    const Driven moved = navigate(view, length, [button](MapView& map, double t) {
        const QPointF place = circling(map, t);
        QMouseEvent move(QEvent::MouseMove, place, map.mapToGlobal(place), Qt::NoButton, button, {});
        QCoreApplication::sendEvent(&map, &move);
    });
    QTest::mouseRelease(&*view, button);
    return moved;
}

/// The wheel is turned for half a second to and for half a second fro.
Driven wheeling(ShownView& view, double length) {
    return navigate(view, length, [](MapView& map, double t) {
        const QPointF middle = map.rect().center();
        const int step = std::fmod(t, 1.0) < 0.5 ? 30 : -30;  // a quarter of a notch, as fine wheels tell
        QWheelEvent event(middle, map.mapToGlobal(middle), {}, {0, step}, Qt::NoButton, {}, Qt::NoScrollPhase,
                          false);
        QCoreApplication::sendEvent(&map, &event);
    });
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
              << " pictures/s (asked " << AskedRate << "), a tick takes up to " << following.tick
              << " ms of the GUI thread, " << following.cores << " cores; all points are there after "
              << whole << " s\n";
    EXPECT_GE(following.rate, LeastRate);
    EXPECT_LT(following.tick, MostTick);
    view->setSettings({});
    view.settle();
    const Driven standing = drive(view, 2.0);
    std::cout << "a robot moves under a camera that stands: " << standing.rate
              << " pictures of the points/s, a tick takes up to " << standing.tick << " ms\n";
    EXPECT_LT(standing.rate, 1.0) << "only robots are painted again";
}

TEST_P(NavigationLatency, FiveMillionPointsAreTurnedShiftedAndZoomedAtTenPicturesASecond) {
    ShownView view(largeMap(5'000'000, 5'000'000 / GetParam()), {}, {1280, 800});
    EXPECT_TRUE(QTest::qWaitFor([&] { return view->settled(); }, 120'000));
    (void)dragging(view, 3.0, Qt::LeftButton);  // learns how much can be drawn
    const auto judge = [](const char* what, const Driven& moved) {
        std::cout << "5 M points in " << GetParam() << " scans, " << what << ": " << moved.rate
                  << " pictures/s (asked " << AskedRate << "), a move takes up to " << moved.tick
                  << " ms of the GUI thread, " << moved.cores << " cores\n";
        EXPECT_GE(moved.rate, LeastRate) << what;
        EXPECT_LT(moved.tick, MostTick) << what;
    };
    judge("turned by hand", dragging(view, 4.0, Qt::LeftButton));
    judge("shifted by hand", dragging(view, 4.0, Qt::MiddleButton));
    judge("zoomed by the wheel", wheeling(view, 4.0));
    const auto stood = Clock::now();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view->settled(); }, 120'000));
    std::cout << "all points are there after " << Seconds(Clock::now() - stood).count() << " s\n";
}

INSTANTIATE_TEST_SUITE_P(Scans, NavigationLatency, testing::Values(100, 1000));

}  // namespace
}  // namespace leitstand::test
