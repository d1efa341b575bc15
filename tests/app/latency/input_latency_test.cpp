#include <atomic>
#include <functional>
#include <iostream>
#include <random>
#include <thread>
#include <vector>

#include <QLabel>

#include <gmock/gmock.h>

#include "tests/app/latency/command_wire.h"
#include "tests/app/latency/gui_watch.h"
#include "tests/app/live/live_page.h"
#include "tests/app/pad/virtual_pad.h"
#include "tests/support/latency.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int Presses = 150;
constexpr int Attempts = 3;                             ///< all of them count
constexpr double AskedToWire = 60.0, AskedAway = 50.0;  ///< [ms]
constexpr double MostToWire = Generous * AskedToWire, MostAway = Generous * AskedAway;

void print(const char* what, const GuiWatch::Figures& figures) {
    std::cout << what << ": " << figures.count << " times, p50 " << figures.p50 << " ms, p99 " << figures.p99
              << " ms, most " << figures.most << " ms\n";
}

/// The live window while the demo runs, and what it says on the wire.
class InputLatency : public LivePage {
protected:
    /// Until everything is to be seen and the selected robot may be driven.
    void whenDriving(const std::function<void()>& take) {
        ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
        take();
        ASSERT_TRUE(soon([&] {
            return robot().grant.mine && robot().drive.listening && robot().drive.focus &&
                   !robot().drive.needsNeutral && m_wire.receives();
        }));
    }
    /// All presses of a few attempts at press(), taken together, are fast enough.
    void expectSoon(const char* what, const std::function<void(bool on)>& turn) {
        std::vector<double> all;
        for (int i = 0; i < Attempts; ++i) {
            const std::vector<double> took = press(turn);
            print(what, GuiWatch::figures(took));
            all.insert(all.end(), took.begin(), took.end());
        }
        const auto figures = GuiWatch::figures(all);
        print("... of all attempts", figures);
        std::cout << "    p99 asked " << AskedToWire << " ms; with the robots on the same computer "
                  << MostToWire << " ms\n";
        ASSERT_EQ(figures.count, static_cast<std::size_t>(Attempts * Presses));
        EXPECT_LE(figures.p99, MostToWire);
    }
    /// Turns to and fro by @p turn, on another thread than the window's; how long each took until the command
    /// was heard [ms].
    [[nodiscard]] std::vector<double> press(const std::function<void(bool on)>& turn) {
        std::vector<double> took;
        std::atomic<bool> done = false, lost = false;
        std::jthread hand([&] {
            std::mt19937 random(3);
            for (int i = 0; i < Presses && !lost; ++i) {
                std::this_thread::sleep_for(std::chrono::milliseconds(30 + random() % 40));
                const bool on = i % 2 == 0;
                const auto since = Clock::now();
                turn(on);
                const auto received = m_wire.waitFor(on);
                lost = !received;
                if (received)
                    took.push_back(std::chrono::duration<double, std::milli>(*received - since).count());
            }
            done = true;
        });
        EXPECT_TRUE(QTest::qWaitFor([&] { return done.load(); }, 5 * Patience));
        EXPECT_FALSE(lost) << "a command never came";
        return took;
    }

    CommandWire m_wire{m_domain};
};

TEST_F(InputLatency, FromAKeyToTheWire) {
    whenDriving([&] { LivePage::press(Qt::Key_F2); });
    expectSoon("key to wire", [&](bool on) {
        QMetaObject::invokeMethod(
            m_window.get(),
            [this, on] {
                on ? QTest::keyPress(m_window.get(), Qt::Key_A)
                   : QTest::keyRelease(m_window.get(), Qt::Key_A);
            },
            Qt::QueuedConnection);
    });
}

TEST_F(InputLatency, LongFromAPadToTheWire) {
    VirtualPad pad;
    ASSERT_TRUE(soon([&] { return m_window->findChild<QLabel*>("word")->text().contains("plugged in"); }));
    whenDriving([&] { pad.push(standard_axis::LeftTrigger, 1.0); });
    expectSoon("pad to wire", [&](bool on) { pad.push(standard_axis::LeftX, on ? -1.0 : 0.0); });
}

// The longest of a run is no share of many: one stroke of bad luck on a computer that others use decides it.
// The median of three runs has to be hit twice by such, and cannot be good when two of three are bad.
TEST_F(InputLatency, TheWindowIsNeverAwayForLong) {
    whenDriving([&] { LivePage::press(Qt::Key_F2); });
    GuiWatch watch;
    std::vector<double> longest;
    for (int i = 0; i < Attempts; ++i) {
        watch.clear();
        QTest::keyPress(m_window.get(), Qt::Key_A);
        QTest::qWait(15'000);
        QTest::keyRelease(m_window.get(), Qt::Key_A);
        print("window away from its events", watch.wall());
        print("... by its own doing", watch.own());
        ASSERT_GT(watch.own().count, 100u);
        longest.push_back(watch.own().most);
    }
    std::cout << "asked " << AskedAway << " ms\n";
    EXPECT_LE(GuiWatch::figures(longest).p50, MostAway);
}

}  // namespace
}  // namespace leitstand::test
