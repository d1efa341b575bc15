#include <chrono>

#include <fmt/format.h>
#include <QFrame>

#include <gtest/gtest.h>

#include "app/services/station/station.h"
#include "app/window/input/selection.h"
#include "core/event/motion_samples.h"
#include "tests/app/live/map_on_screen.h"

namespace leitstand::test {
namespace {

/// A robot on its way to a place while the map moves.
class GoalOnAMovingMap : public LiveMapOfAHall {
protected:
    /// Kurt3D is on its way, and the map asks whether it meets itself @p off from there [m].
    void sendAndAsk(const Eigen::Vector3d& off) {
        ASSERT_NO_FATAL_FAILURE(mapTwoScans(Then::Waits));
        (void)askWhetherItMeetsItself(off);
        ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty() && place("kurt3d").placed; }));
        m_window->layouts().use("map");
        m_window->selection().select("kurt3d");
        // Once it drives, it scans on, and what it scans there would hold the map where it is.
        ASSERT_TRUE(soon([&] { return m_window->commands().find("loop.close")->isEnabled(); })) << "asked";
        emit map().groundActivated(place("kurt3d").baseInMap * Eigen::Vector3d(Far, 0, 0));
        ASSERT_TRUE(soon([&] { return goals() == 1; }))
            << reported() << "; " << m_window->recent().join("; ").toStdString();
    }
    /// On a busy machine the map takes seconds to move, and the robot must be on its way until then [m].
    static constexpr double Far = 6.0;
    /// That Kurt3D was sent so far.
    [[nodiscard]] std::size_t goals() const {
        const auto state = station().mission()->robots.at("kurt3d");
        const auto stream = state->streams.find("/kurt3d/goal_pose");
        return stream == state->streams.end() ? 0 : stream->second.events;
    }
    /// Where the scans lie, for a failure's text.
    [[nodiscard]] std::string mapped() const {
        std::string text = "scans at";
        const LiveMapPtr map = station().mapping().scans();
        for (const auto& one : map->scans) {
            const Eigen::Vector3d place = one.pose.scanInMap.translation();
            text += fmt::format(" ({:.2f}, {:.2f}){}", place.x(), place.y(), one.counts() ? "" : "?");
        }
        return text + "; " + m_window->recent().join("; ").toStdString();
    }
    [[nodiscard]] const QFrame& asked() const { return *m_window->findChild<QFrame*>("goalQuestion"); }
};

TEST_F(GoalOnAMovingMap, ByMuchItIsWithdrawnAndAskedAbout) {
    ASSERT_NO_FATAL_FAILURE(sendAndAsk({1.8, 2.4, 0.0}));
    std::size_t sent = goals();
    trigger("loop.close");
    EXPECT_TRUE(soon([&] { return asked().isVisible(); })) << reported() << "; " << mapped();
    EXPECT_TRUE(asked().accessibleName().startsWith("Kurt3D: the map moved by "))
        << asked().accessibleName().toStdString();
    lookAt("goal_question");
    EXPECT_TRUE(soon([&] { return goals() > sent; })) << "it is told to stay where it is";
    sent = goals();
    trigger("goal.again");
    EXPECT_FALSE(asked().isVisible());
    EXPECT_TRUE(soon([&] { return goals() > sent; })) << "to where that place lies now";
}

TEST_F(GoalOnAMovingMap, AStoppedRobotIsSentNowhere) {
    ASSERT_NO_FATAL_FAILURE(sendAndAsk({0.3, 0.4, 0.0}));
    station().stopAll();
    EXPECT_FALSE(station().goTo("kurt3d", PoseSample{}).ok()) << "from the moment on, whatever asks for it";
    ASSERT_TRUE(soon([&] { return robot().stop.standing; }));
    // What was sent before, as when a scan moved the map a little, is heard and counted by now.
    std::size_t sent = goals();
    for (int quiet = 0; quiet < 10; quiet = goals() == sent ? quiet + 1 : 0) {
        sent = goals();
        QTest::qWait(100);
    }
    const auto newest = [&] { return station().mapping().scans()->scans.back().pose.scanInMap; };
    const Pose before = newest();
    trigger("loop.close");
    ASSERT_TRUE(soon([&] { return distanceBetween(newest(), before) > 0.05; }));
    const Time received = place("kurt3d").stamp;
    EXPECT_TRUE(soon([&] { return place("kurt3d").stamp > received + std::chrono::seconds(1); }));
    EXPECT_EQ(goals(), sent);
    EXPECT_FALSE(asked().isVisible());
}

}  // namespace
}  // namespace leitstand::test
