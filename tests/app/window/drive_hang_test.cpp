// Keys and gamepads that are held while the window hangs.
#include <chrono>
#include <optional>
#include <thread>

#include <QTest>
#include <QWidget>

#include <gtest/gtest.h>

#include "app/window/input/drive_input.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand::test {
namespace {

/// The setpoint that the sticks are told to, and a window that hangs.
class DriveHang : public testing::Test {
protected:
    DriveHang() {
        RobotDescription robot;
        robot.maxSpeed = 0.5;
        robot.maxTurnRate = 1.0;
        m_input.setRobot(robot);
        m_window.show();
        m_setpoint.permit(true);
        QObject::connect(&m_input, &DriveInput::sticks, [this](const DriveVelocity& velocity) {
            const auto now = std::chrono::steady_clock::now();
            m_setpoint.set(velocity, now);
            m_moves = m_setpoint.at(now).forward;
        });
    }
    [[nodiscard]] double moves() const { return m_moves; }  ///< when the sticks were told last [m/s]
    /// Lets the sticks be told, by the rhythm of keys or by a pad that is held.
    void update() {
        if (m_pad) m_input.setPad(*m_pad, true);
        QTest::qWait(60);
    }
    void hang() {
        std::this_thread::sleep_for(std::chrono::milliseconds(900));  // as a window that hangs
        for (int i = 0; i < 10; ++i) {
            update();
            EXPECT_EQ(moves(), 0.0) << "held all the time";
        }
    }
    QWidget m_window;
    DriveInput m_input{m_window};
    DriveSetpoint m_setpoint{DriveLimits{0.5, 1.0}};
    std::optional<DriveVelocity> m_pad;
    double m_moves = 0.0;
};

TEST_F(DriveHang, KeysThatWereHeldThroughItMoveNothingUntilTheyWereLetGo) {
    m_input.setFocus(true);
    update();
    QTest::keyPress(&m_window, Qt::Key_W);
    update();
    ASSERT_GT(moves(), 0.2);
    hang();
    QTest::keyRelease(&m_window, Qt::Key_W);
    update();
    QTest::keyPress(&m_window, Qt::Key_W);
    update();
    EXPECT_GT(moves(), 0.2);
}

TEST_F(DriveHang, APadThatWasHeldThroughItMovesNothingUntilItsSticksWereLetGo) {
    m_pad = DriveVelocity{};
    update();
    m_pad = DriveVelocity{0.3, 0.0, 0.0};
    update();
    ASSERT_GT(moves(), 0.2);
    hang();
    m_pad = DriveVelocity{};
    update();
    m_pad = DriveVelocity{0.3, 0.0, 0.0};
    update();
    EXPECT_GT(moves(), 0.2);
}

TEST_F(DriveHang, KeysBesideAPadMoveNothingEither) {
    m_input.setFocus(true);
    m_pad = DriveVelocity{};
    update();
    QTest::keyPress(&m_window, Qt::Key_W);
    m_pad = DriveVelocity{0.3, 0.0, 0.0};
    update();
    ASSERT_GT(moves(), 0.2);
    hang();
    // The pad lets go: the key that is still held has to be pressed anew.
    m_pad.reset();
    m_input.setPad({}, false);
    update();
    EXPECT_EQ(moves(), 0.0);
    QTest::keyRelease(&m_window, Qt::Key_W);
    QTest::keyPress(&m_window, Qt::Key_W);
    update();
    EXPECT_GT(moves(), 0.2);
}

}  // namespace
}  // namespace leitstand::test
