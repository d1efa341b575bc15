// Fields that are written into beside driving with keys.
#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>
#include <QStringListModel>
#include <QTest>
#include <QWidget>

#include <gtest/gtest.h>

#include "app/window/input/drive_input.h"

namespace leitstand::test {
namespace {

/// A window with a field of text, and who has the sticks.
class WritingTest : public testing::Test {
protected:
    WritingTest() {
        RobotDescription robot;
        robot.maxSpeed = 0.5;
        robot.maxTurnRate = 1.0;
        m_input.setRobot(robot);
        QObject::connect(&m_input, &DriveInput::sticks,
                         [this](const DriveVelocity& velocity) { m_sticks = velocity; });
        m_window.show();
        m_window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&m_window));
        m_field.clearFocus();  // the only one that takes it has it at first
    }
    void write(const char* text) { QTest::keyClicks(&m_field, text); }

    void hold(Qt::Key key) { QTest::keyPress(&m_window, key); }

    QWidget m_window;
    QLineEdit m_field{&m_window};
    DriveInput m_input{m_window};
    DriveVelocity m_sticks;
};

TEST_F(WritingTest, WhoWritesIntoAFieldDoesNotDrive) {
    m_field.show();
    m_input.setFocus(true);
    hold(Qt::Key_W);
    ASSERT_GT(m_sticks.forward, 0.0);
    m_field.setFocus();
    EXPECT_FALSE(m_input.keysHaveFocus());
    EXPECT_TRUE(isZero(m_sticks)) << "at once";
    QSignalSpy halted(&m_input, &DriveInput::halted);
    write("was Anna");
    EXPECT_EQ(m_field.text(), "was Anna");
    EXPECT_EQ(halted.count(), 0);
    EXPECT_TRUE(isZero(m_sticks));
}

TEST_F(WritingTest, TheDriveFocusTakesTheKeyboardFromAField) {
    m_field.show();
    m_field.setFocus();
    ASSERT_TRUE(m_field.hasFocus());
    m_input.setFocus(true);
    EXPECT_TRUE(m_input.keysHaveFocus());
    EXPECT_FALSE(m_field.hasFocus());
}

TEST_F(WritingTest, TheGamepadDrivesOnWhileSomethingIsWritten) {
    m_field.show();
    m_input.setPad({0.2, 0.0, 0.0}, true);
    m_field.setFocus();
    QSignalSpy halted(&m_input, &DriveInput::halted);
    write("ag sd");
    EXPECT_EQ(m_field.text(), "ag sd");
    EXPECT_EQ(halted.count(), 0);
    EXPECT_FALSE(m_input.withoutEyes());
    EXPECT_DOUBLE_EQ(m_sticks.forward, 0.2);
}

TEST_F(WritingTest, WhatWasHeldBeforeAFieldIsWrittenIntoEndsThere) {
    m_field.show();
    m_input.setPad({0.2, 0.0, 0.0}, true);
    hold(Qt::Key_G);
    ASSERT_TRUE(m_input.withoutEyes());
    m_field.setFocus();
    EXPECT_FALSE(m_input.withoutEyes()) << "nobody would tell when it is let go of";
    QTest::keyRelease(&m_field, Qt::Key_G);
    EXPECT_FALSE(m_input.withoutEyes());
}

TEST_F(WritingTest, AListIsNoField) {
    QStringListModel lines({"an alarm", "another one"});
    QListView list(&m_window);
    list.setModel(&lines);
    list.show();
    m_input.setFocus(true);
    list.setFocus();
    ASSERT_TRUE(list.hasFocus());
    EXPECT_TRUE(m_input.keysHaveFocus());
}

}  // namespace
}  // namespace leitstand::test
