// Flippers and arm of a stock robot in the window: keys, presets, STOP.
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QAction>

#include <gtest/gtest.h>

#include "app/services/station/joints/joint_moving.h"
#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/layouts/layout_feature.h"
#include "core/base/pose.h"
#include "core/base/time.h"
#include "tests/app/live/live_page.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "widgets/joints/joints_panel.h"

namespace leitstand::test {
namespace {

class TrackedPage : public LivePage {
protected:
    TrackedPage() : LivePage(Robots::None, {described()}) {
        m_robot = std::make_unique<ChildProcess>(
            program("leitstand-robot"),
            std::vector<std::string>{"stock", "tracked", "--domain", std::to_string(m_domain.number()),
                                     "--arena", "yellow", "--seed", "7"});
    }
    /// Without its e-stop, which would end the motion whatever the station sends.
    [[nodiscard]] static RobotDescription described() {
        RobotDescription robot = shippedRobot("tracked");
        robot.services.clear();
        return robot;
    }
    /// Where a joint is [degrees]; NaN: unknown.
    [[nodiscard]] double at(const char* group, std::size_t joint) const {
        const auto view = station().joints().view("tracked", group);
        const auto position = view ? view->positions.at(joint) : std::nullopt;
        return position ? inDegrees(*position) : std::nan("");
    }
    [[nodiscard]] bool drives() {
        m_window->setDriving(true);
        return soon([&] {
            const auto view = station().joints().view("tracked", "flippers");
            return view && view->mayMove && view->positions.at(0).has_value();
        });
    }
    void trigger(const char* id) { m_window->commands().find(QLatin1String(id))->trigger(); }
    /// How far a joint moves within @p wait [degrees].
    [[nodiscard]] double moves(const char* group, std::size_t joint, int wait) const {
        const double before = at(group, joint);
        QTest::qWait(wait);
        return std::abs(at(group, joint) - before);
    }

    std::unique_ptr<ChildProcess> m_robot;
};

TEST_F(TrackedPage, KeysRaiseWhatIsChosenAndPresetsMoveAllOfAGroup) {
    ASSERT_TRUE(drives());
    QTest::keyPress(m_window.get(), Qt::Key_J);
    EXPECT_TRUE(soon([&] { return at("flippers", 0) > 25 && at("flippers", 1) > 25; }));
    QTest::keyRelease(m_window.get(), Qt::Key_J);
    EXPECT_NEAR(at("flippers", 2), 0.0, 1.0) << "the rear ones were not chosen";
    QTest::qWait(500);
    EXPECT_LT(moves("flippers", 0, 500), 1.0) << "the key was let go";
    trigger("joints.next");
    QTest::keyPress(m_window.get(), Qt::Key_K);
    EXPECT_TRUE(soon([&] { return at("flippers", 2) < -20; }));
    QTest::keyRelease(m_window.get(), Qt::Key_K);
    lookAt("joints-by-hand");
    trigger("joints.preset1");
    EXPECT_TRUE(soon([&] {
        return std::abs(at("flippers", 0) - 90) < 3 && std::abs(at("flippers", 3) - 90) < 3;
    })) << "Drive";
    trigger("joints.next");
    trigger("joints.preset2");
    EXPECT_TRUE(soon([&] { return std::abs(at("arm", 0) - 80) < 4 && std::abs(at("arm", 1) + 150) < 4; }))
        << "the arm's second preset, by velocities: " << at("arm", 0) << " " << at("arm", 1);
    lookAt("joints-presets");
}

TEST_F(TrackedPage, AStopHoldsTheArmThatWouldGoOn) {
    ASSERT_TRUE(drives());
    ASSERT_TRUE(soon([&] { return !std::isnan(at("arm", 0)); }));
    trigger("joints.next");
    trigger("joints.next");
    QTest::keyPress(m_window.get(), Qt::Key_J);
    ASSERT_TRUE(soon([&] { return at("arm", 0) > 10; }));
    station().stopAll();
    QTest::qWait(400);
    EXPECT_LT(moves("arm", 0, 500), 0.5);
    ASSERT_TRUE(soon([&] { return station().release("tracked").ok(); }));
    ASSERT_TRUE(soon([&] { return station().joints().view("tracked", "arm")->mayMove; }));
    EXPECT_LT(moves("arm", 0, 500), 0.5) << "the key is still held, and must be let go first";
    QTest::keyRelease(m_window.get(), Qt::Key_J);
    QTest::qWait(200);
    QTest::keyPress(m_window.get(), Qt::Key_J);
    EXPECT_TRUE(soon([&] { return at("arm", 0) > 25; }));
    QTest::keyRelease(m_window.get(), Qt::Key_J);
}

TEST_F(TrackedPage, AKeyIsLetGoWhateverElseIsHeldMeanwhile) {
    ASSERT_TRUE(drives());
    QTest::keyPress(m_window.get(), Qt::Key_J);
    ASSERT_TRUE(soon([&] { return at("flippers", 0) > 5; }));
    QTest::keyPress(m_window.get(), Qt::Key_Shift);
    QTest::keyRelease(m_window.get(), Qt::Key_J, Qt::ShiftModifier);
    QTest::keyRelease(m_window.get(), Qt::Key_Shift);
    QTest::qWait(500);
    EXPECT_LT(moves("flippers", 0, 500), 1.0);
}

TEST_F(TrackedPage, SpaceEndsAPresetAlsoWithoutTheDriveFocus) {
    ASSERT_TRUE(drives());
    m_window->setDriving(false);
    trigger("joints.preset1");
    ASSERT_TRUE(soon([&] { return at("flippers", 0) > 15; }));
    press(Qt::Key_Space);
    QTest::qWait(400);
    EXPECT_LT(moves("flippers", 0, 500), 1.0);
    EXPECT_LT(at("flippers", 0), 80.0);
}

TEST_F(TrackedPage, ClosingTheWindowEndsAMotion) {
    ASSERT_TRUE(drives());
    trigger("joints.next");
    trigger("joints.next");
    QTest::keyPress(m_window.get(), Qt::Key_J);
    ASSERT_TRUE(soon([&] { return at("arm", 0) > 10; }));
    restart();
    ASSERT_TRUE(soon([&] { return !std::isnan(at("arm", 0)); }));
    QTest::qWait(300);
    EXPECT_LT(moves("arm", 0, 500), 0.5) << "an arm goes on with the last velocity that it heard";
}

TEST_F(TrackedPage, WithoutDriveControlNothingMovesAndTheWindowSaysWhy) {
    ASSERT_TRUE(soon([&] { return !std::isnan(at("flippers", 0)); }));
    QTest::keyPress(m_window.get(), Qt::Key_J);
    QTest::qWait(500);
    QTest::keyRelease(m_window.get(), Qt::Key_J);
    EXPECT_NEAR(at("flippers", 0), 0.0, 0.5);
    EXPECT_FALSE(m_window->recent().filter(QStringLiteral("drive control")).isEmpty());
    EXPECT_TRUE(m_window->panes().has(QStringLiteral("joints")));
}

}  // namespace
}  // namespace leitstand::test
