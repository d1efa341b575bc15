#include <algorithm>
#include <chrono>
#include <iostream>

#include <gtest/gtest.h>
#include <QElapsedTimer>
#include <QTimer>

#include "tests/widgets/map_view/maps.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

double millisecondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return Milliseconds(std::chrono::steady_clock::now() - start).count();
}

/// Measures how late a timer of 2 ms fires on the GUI thread.
class LatenessMeter {
public:
    LatenessMeter() {
        m_timer.setInterval(Interval);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] {
            const double elapsed = double(m_clock.nsecsElapsed()) / 1e6;
            m_worst = std::max(m_worst, elapsed - Interval);
            m_clock.start();
        });
        m_clock.start();
        m_timer.start();
    }
    [[nodiscard]] double worst() const { return m_worst; }  ///< [ms]

private:
    static constexpr int Interval = 2;
    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_worst = 0.0;
};

TEST(MapViewLatency, GuiStaysResponsiveWhileAMillionPointsAreTurned) {
    ShownView view(largeMap(1'000'000), {}, {1280, 800});
    const double full = millisecondsOf([&] { EXPECT_FALSE(view->picture().isNull()); });
    LatenessMeter lateness;
    int pictures = 0;
    QObject::connect(&*view, &MapView::becameSettled, &*view, [&] { ++pictures; });
    for (int turn = 0; turn < 3; ++turn) view.drag(Qt::LeftButton, {400, 400}, {460, 410});
    EXPECT_GE(pictures, 1);
    std::cout << "a full picture of 1 M points: " << full << " ms; GUI late by at most " << lateness.worst()
              << " ms\n";
    EXPECT_LT(lateness.worst(), 100);
}

TEST(MapViewLatency, AddingAScanCostsTheGuiAlmostNothing) {
    const MapPtr all = largeMap(1'000'000);
    auto before = std::make_shared<Map>(*all);
    before->scans.pop_back();
    ShownView view(before);
    const double added = millisecondsOf([&] { view->setMap(all); });
    view.settle();
    std::cout << "a scan more among 1 M points: " << added << " ms of the GUI thread\n";
    EXPECT_LT(added, 20);
}

TEST(MapViewLatency, PickingAmongAMillionPointsIsInstant) {
    ShownView view(largeMap(1'000'000), {}, {1280, 800});
    double worst = 0;
    for (int x = 200; x < 1'100; x += 60) {
        worst = std::max(worst, millisecondsOf([&] { (void)view->pick({x, 400}); }));
    }
    std::cout << "picking among 1 M points: at most " << worst << " ms\n";
    EXPECT_LT(worst, 100);
}

}  // namespace
}  // namespace leitstand::test
