#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include <QEvent>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include "app/window/live/demo_robots.h"
#include "core/perception/surroundings/virtual_scan_view.h"
#include "tests/app/live/live_page.h"
#include "tests/support/latency.h"
#include "tests/support/net/radio_link.h"
#include "tests/support/places.h"
#include "widgets/virtual_scan/virtual_scan_pane.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int Patience = 60'000;                        ///< until robots are heard [ms]
constexpr int Counted = 10'000;                         ///< [ms]
constexpr double Wanted = 10.0, LeastOnABadLink = 2.0;  ///< pictures a second
constexpr double LeastUsually = Wanted / Generous;

/// Counts how often the pane is painted with something that the robot has seen since the picture before.
class ScanWatch final : public QObject {
public:
    ScanWatch(VirtualScanPane& pane, const LiveBridge& bridge) : m_bridge(bridge) {
        pane.installEventFilter(this);
    }
    bool eventFilter(QObject* /*pane*/, QEvent* event) override {
        if (event->type() == QEvent::Paint) look();
        return false;
    }
    void clear() {
        pictures = 0;
        longestGap = 0.0;
        m_painted = Clock::now();
    }
    /// What is past the end counts as a gap too.
    void end() { gapUntil(Clock::now()); }

    int pictures = 0;         ///< new ones
    double longestGap = 0.0;  ///< between them [s]

private:
    void look() {
        const auto& view = m_bridge.moment().view("kurt3d").around;
        if (!view || !std::isfinite(view->youngest())) return;
        // Ages run on by themselves; when the newest sector was looked at does not.
        const double seen =
            std::chrono::duration<double>(view->at.time_since_epoch()).count() - view->youngest();
        if (m_seen && seen < *m_seen + 0.01) return;
        m_seen = seen;
        ++pictures;
        gapUntil(Clock::now());
    }
    void gapUntil(Clock::time_point now) {
        longestGap = std::max(longestGap, std::chrono::duration<double>(now - m_painted).count());
        m_painted = now;
    }

    const LiveBridge& m_bridge;
    std::optional<double> m_seen;  ///< robot's clock [s]
    Clock::time_point m_painted = Clock::now();
};

/// The live window on both simulated robots, with a network between them that a test may choose.
class VirtualScanLatency : public testing::Test {
protected:
    ~VirtualScanLatency() override {
        m_live.window.reset();
        m_live.bridge.reset();
        m_robots.reset();
    }
    void startRobots() {
        DemoSettings demo;
        demo.program = QString::fromStdString(program("leitstand-robot"));
        demo.domain = m_domain.number();
        m_robots = std::make_unique<DemoRobots>(demo);
        m_robots->start();
    }
    void openStation() { m_live = openLiveStation(m_folder.path().toStdString(), m_domain.number()); }

    /// New pictures a second on the average.
    void expectAtLeast(double least, const char* link) {
        auto* const pane = m_live.window->findChild<VirtualScanPane*>();
        ASSERT_NE(pane, nullptr);
        ASSERT_TRUE(QTest::qWaitFor([&] { return pane->isVisible(); }, Patience));
        ScanWatch watch(*pane, *m_live.bridge);
        ASSERT_TRUE(QTest::qWaitFor([&] { return watch.pictures > 20; }, 2 * Patience))
            << watch.pictures << " pictures";
        watch.clear();
        const auto began = Clock::now();
        QTest::qWait(Counted);
        const double took = std::chrono::duration<double>(Clock::now() - began).count();
        watch.end();
        const double rate = watch.pictures / took;
        std::printf(
            "virtual scan, %s: %.1f new pictures a second (at least %.0f, wanted %.0f), at most "
            "%.2f s between two\n",
            link, rate, least, Wanted, watch.longestGap);
        EXPECT_GE(rate, least);
        EXPECT_LE(watch.longestGap, 1.0) << "and evenly";
    }

    const TestDomain m_domain;
    const QTemporaryDir m_folder;
    std::optional<RadioLink> m_radio;  ///< outlives those who speak over it
    LiveStation m_live;
    std::unique_ptr<DemoRobots> m_robots;
};

TEST_F(VirtualScanLatency, IsDrawnAnewTenTimesASecond) {
    openStation();
    startRobots();
    expectAtLeast(LeastUsually, "usual link");
}

TEST_F(VirtualScanLatency, IsDrawnAnewTwiceASecondOnABadLink) {
    if (const std::string why = whyNoNamespaces(); !why.empty())
        GTEST_SKIP() << "SKIPPED: the radio link needs network namespaces and TUN: " << why;
    m_radio.emplace();  // 10 Mbit/s, 20 ms, 5 % loss
    {
        const InNamespace here(m_radio->station());
        openStation();
    }
    {
        const InNamespace there(m_radio->robots());
        startRobots();
    }
    expectAtLeast(LeastOnABadLink, "10 Mbit/s with 5 % loss");
    EXPECT_GT(m_radio->bytes(), 100'000u) << "it went over the radio";
}

}  // namespace
}  // namespace leitstand::test
