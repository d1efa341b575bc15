#include "app/window/input/drive_input.h"

#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/window/input/worked_in.h"

namespace leitstand::test {
namespace {

RobotDescription robot() {
    RobotDescription description;
    description.name = "kurt3d";
    description.maxSpeed = 0.5;
    description.maxTurnRate = 1.0;
    return description;
}

TEST(DrivingKeys, AreTheUsualOnesAndThoseOfTheRobotsFiles) {
    RobotDescription own = robot();
    own.bindings = {{"forward", "I"}, {"back", "Esc"}, {"left", "nonsense, here"}, {"co2", "K"}};
    const std::vector<Qt::Key> keys = drivingKeys({robot(), own});
    EXPECT_THAT(keys, testing::IsSupersetOf(
                          {Qt::Key_W, Qt::Key_Up, Qt::Key_Space, Qt::Key_G, Qt::Key_Escape, Qt::Key_I}));
    EXPECT_THAT(keys, testing::Not(testing::Contains(Qt::Key_K)));
    EXPECT_THAT(keys, testing::Not(testing::Contains(Qt::Key_Shift))) << "it comes with others";
}

class DriveInputTest : public testing::Test {
protected:
    DriveInputTest() {
        m_input.setRobot(robot());
        QObject::connect(&m_input, &DriveInput::sticks,
                         [this](const DriveVelocity& velocity) { m_sticks = velocity; });
        m_window.show();
    }
    void hold(Qt::Key key) { QTest::keyPress(&m_window, key); }
    void let(Qt::Key key) { QTest::keyRelease(&m_window, key); }
    /// The sticks once they were told anew.
    [[nodiscard]] DriveVelocity sticks() {
        QSignalSpy spy(&m_input, &DriveInput::sticks);
        EXPECT_TRUE(spy.wait(2'000));
        return m_sticks;
    }

    QWidget m_window;
    DriveInput m_input{m_window};
    DriveVelocity m_sticks;
};

TEST_F(DriveInputTest, KeysDriveOnlyInTheDriveFocus) {
    hold(Qt::Key_W);
    EXPECT_TRUE(isZero(m_sticks));
    let(Qt::Key_W);
    m_input.setFocus(true);
    EXPECT_TRUE(isZero(sticks()));
    hold(Qt::Key_W);
    EXPECT_GT(sticks().forward, 0.2);
    hold(Qt::Key_A);
    EXPECT_GT(sticks().turn, 0.2) << "left is counter-clockwise";
    let(Qt::Key_W);
    EXPECT_EQ(sticks().forward, 0.0);
    let(Qt::Key_A);
    EXPECT_TRUE(isZero(sticks()));
}

TEST_F(DriveInputTest, ALetterThatWouldDriveIsNotSwallowedWithoutAWord) {
    QSignalSpy vain(&m_input, &DriveInput::pressedInVain);
    hold(Qt::Key_W);
    let(Qt::Key_W);
    EXPECT_EQ(vain.size(), 1);
    QTest::keyPress(&m_window, Qt::Key_W, Qt::ControlModifier);
    hold(Qt::Key_X);
    hold(Qt::Key_Up);
    EXPECT_EQ(vain.size(), 1) << "others are of lists and shortcuts";
    QLineEdit field(&m_window);
    field.show();
    QTest::keyPress(&field, Qt::Key_W);
    EXPECT_EQ(vain.size(), 1) << "it is a letter there";
    m_input.setFocus(true);
    hold(Qt::Key_W);
    EXPECT_EQ(vain.size(), 1);
}

TEST_F(DriveInputTest, AKeyThatIsLetGoIntoAMenuIsLetGo) {
    m_input.setFocus(true);
    hold(Qt::Key_W);
    ASSERT_GT(sticks().forward, 0.2);
    QMenu menu(&m_window);
    menu.addAction("Anything");
    menu.popup(m_window.mapToGlobal(QPoint(5, 5)));
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&menu));
    QTest::keyRelease(&menu, Qt::Key_W);
    EXPECT_EQ(sticks().forward, 0.0);
}

/// As the keyboard tells it: @p code is the place of the key, @p key what it means with the modifiers of now.
void tellKey(QWidget& window, QEvent::Type type, quint32 code, Qt::Key key) {
    QKeyEvent event(type, key, Qt::NoModifier, code, 0, 0);
    QApplication::sendEvent(&window, &event);
}

TEST_F(DriveInputTest, AKeyThatAModifierRenamedMeanwhileIsLetGo) {
    m_input.setFocus(true);
    tellKey(m_window, QEvent::KeyPress, 25, Qt::Key_W);
    ASSERT_GT(sticks().forward, 0.2);
    tellKey(m_window, QEvent::KeyRelease, 25, static_cast<Qt::Key>(0x141));  // AltGr+W on many keyboards
    EXPECT_EQ(sticks().forward, 0.0);
}

TEST_F(DriveInputTest, NoFileTakesTheKeysThatStop) {
    RobotDescription odd = robot();
    odd.bindings = {{"forward", "Esc"}, {"back", "Space"}};
    m_input.setRobot(odd);
    m_input.setFocus(true);
    hold(Qt::Key_Escape);
    EXPECT_TRUE(isZero(sticks()));
}

TEST_F(DriveInputTest, ArrowsShiftAndCtrl) {
    m_input.setFocus(true);
    hold(Qt::Key_Up);
    const double usual = sticks().forward;
    hold(Qt::Key_Shift);
    EXPECT_LT(sticks().forward, usual);
    let(Qt::Key_Shift);
    hold(Qt::Key_Control);
    EXPECT_DOUBLE_EQ(sticks().forward, 0.5);
}

/// Whether @p key would reach the shortcuts of the window.
bool isShortcut(QWidget& window, Qt::Key key, Qt::KeyboardModifiers with) {
    QKeyEvent event(QEvent::ShortcutOverride, key, with);
    event.ignore();
    QApplication::sendEvent(&window, &event);
    return !event.isAccepted();
}

TEST_F(DriveInputTest, ShortcutsWithShiftAndCtrlWorkUntilAKeyMovesTheRobot) {
    m_input.setFocus(true);
    EXPECT_TRUE(isShortcut(m_window, Qt::Key_Z, Qt::ControlModifier));
    EXPECT_TRUE(isShortcut(m_window, Qt::Key_F, Qt::ShiftModifier));
    EXPECT_TRUE(isShortcut(m_window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier));
    EXPECT_FALSE(isShortcut(m_window, Qt::Key_S, Qt::ControlModifier)) << "a key that drives";
    hold(Qt::Key_Control);
    EXPECT_TRUE(isShortcut(m_window, Qt::Key_Z, Qt::ControlModifier)) << "the robot stands";
    hold(Qt::Key_W);
    EXPECT_FALSE(isShortcut(m_window, Qt::Key_Z, Qt::ControlModifier))
        << "the map follows by Z: with \"fast\" held it must not undo anything";
    EXPECT_FALSE(isShortcut(m_window, Qt::Key_F, Qt::ShiftModifier));
    EXPECT_TRUE(isShortcut(m_window, Qt::Key_Z, {}));
    EXPECT_TRUE(isShortcut(m_window, Qt::Key_Escape, Qt::ControlModifier)) << "stops, whatever is held";
    let(Qt::Key_W);
    EXPECT_FALSE(isShortcut(m_window, Qt::Key_Z, Qt::ControlModifier)) << "between two taps of W";
    let(Qt::Key_Control);
    EXPECT_TRUE(isShortcut(m_window, Qt::Key_Z, Qt::ControlModifier));
}

TEST_F(DriveInputTest, SpaceLetsGoAndAKeyThatIsStillHeldDoesNotDriveOn) {
    m_input.setFocus(true);
    hold(Qt::Key_W);
    ASSERT_GT(sticks().forward, 0.0);
    hold(Qt::Key_Space);
    EXPECT_TRUE(isZero(sticks()));
    // The keyboard repeats the key that is held.
    QKeyEvent repeated(QEvent::KeyPress, Qt::Key_W, Qt::NoModifier, "w", true);
    QCoreApplication::sendEvent(&m_window, &repeated);
    EXPECT_TRUE(isZero(sticks()));
}

TEST_F(DriveInputTest, SpaceIsToldOnceWhateverElseIsHeld) {
    QSignalSpy halted(&m_input, &DriveInput::halted);
    hold(Qt::Key_Space);
    EXPECT_EQ(halted.count(), 0) << "without the drive focus it is no key of driving";
    m_input.setFocus(true);
    hold(Qt::Key_Space);
    let(Qt::Key_Space);
    EXPECT_EQ(halted.count(), 1);
}

TEST_F(DriveInputTest, TheOverrideIsHeldAndEndsWithTheKeyOrTheFocus) {
    hold(Qt::Key_G);
    EXPECT_FALSE(m_input.withoutEyes());
    let(Qt::Key_G);
    m_input.setFocus(true);
    hold(Qt::Key_G);
    EXPECT_TRUE(m_input.withoutEyes());
    let(Qt::Key_G);
    EXPECT_FALSE(m_input.withoutEyes());
    hold(Qt::Key_G);
    m_input.setFocus(false);
    EXPECT_FALSE(m_input.withoutEyes());
}

TEST_F(DriveInputTest, TheFocusEndsWithTheWindowsAndTheSticksAreZero) {
    m_input.setFocus(true);
    hold(Qt::Key_W);
    ASSERT_GT(sticks().forward, 0.0);
    QSignalSpy ended(&m_input, &DriveInput::focusChanged);
    QEvent deactivated(QEvent::WindowDeactivate);
    QCoreApplication::sendEvent(&m_window, &deactivated);
    ASSERT_EQ(ended.count(), 1);
    EXPECT_FALSE(m_input.hasFocus());
    EXPECT_TRUE(isZero(m_sticks)) << "told at once";
    m_input.setFocus(true);
    EXPECT_TRUE(isZero(sticks())) << "keys of before are forgotten";
}

TEST_F(DriveInputTest, ARobotsFileBindsOtherKeys) {
    RobotDescription other = robot();
    other.bindings = {{"forward", "I"}, {"left", "nonsense key"}};
    m_input.setRobot(other);
    m_input.setFocus(true);
    hold(Qt::Key_I);
    EXPECT_GT(sticks().forward, 0.0);
}

TEST_F(DriveInputTest, AnotherRobotEndsTheFocus) {
    m_input.setFocus(true);
    hold(Qt::Key_W);
    ASSERT_GT(sticks().forward, 0.0);
    m_input.setRobot(robot());
    EXPECT_FALSE(m_input.hasFocus());
    EXPECT_TRUE(isZero(m_sticks));
}

TEST_F(DriveInputTest, ThePadsTriggerTakesTheSticksWithoutTheDriveFocusAndGivesThemBack) {
    QSignalSpy changed(&m_input, &DriveInput::focusChanged);
    m_input.setPad({0.2, 0.0, 0.0}, true);
    EXPECT_TRUE(m_input.hasFocus());
    EXPECT_FALSE(m_input.keysHaveFocus());
    EXPECT_DOUBLE_EQ(m_sticks.forward, 0.2);
    hold(Qt::Key_W);
    EXPECT_DOUBLE_EQ(m_sticks.forward, 0.2) << "keys do nothing";
    m_input.setPad({}, false);
    EXPECT_TRUE(isZero(m_sticks));
    EXPECT_FALSE(m_input.hasFocus());
    EXPECT_EQ(changed.count(), 2);
}

TEST_F(DriveInputTest, KeysAndPadNeverDriveTogether) {
    m_input.setFocus(true);
    hold(Qt::Key_W);
    ASSERT_GT(m_sticks.forward, 0.0);
    m_input.setPad({}, true);
    EXPECT_TRUE(isZero(m_sticks)) << "the pad has them, neutral";
    QTest::qWait(60);  // the keys' rhythm
    EXPECT_TRUE(isZero(m_sticks));
    hold(Qt::Key_A);
    EXPECT_TRUE(isZero(m_sticks));
    m_input.setPad({}, false);
    EXPECT_TRUE(m_input.keysHaveFocus());
    EXPECT_TRUE(isZero(sticks())) << "keys that are still held have to be pressed anew";
    let(Qt::Key_W);
    hold(Qt::Key_W);
    EXPECT_GT(sticks().forward, 0.0);
}

TEST_F(DriveInputTest, SpaceAndAnotherRobotMakeThePadLetGo) {
    QSignalSpy mustLetGo(&m_input, &DriveInput::padMustLetGo);
    m_input.setPad({0.2, 0.0, 0.0}, true);
    hold(Qt::Key_Space);
    EXPECT_TRUE(isZero(m_sticks));
    EXPECT_FALSE(m_input.hasFocus());
    EXPECT_EQ(mustLetGo.count(), 1);
    m_input.setPad({0.2, 0.0, 0.0}, true);
    m_input.setRobot(robot());
    EXPECT_TRUE(isZero(m_sticks));
    EXPECT_EQ(mustLetGo.count(), 2);
    m_input.setPad({0.2, 0.0, 0.0}, true);
    m_input.setPad({}, false);
    EXPECT_EQ(mustLetGo.count(), 2) << "its own letting go is enough";
}

TEST_F(DriveInputTest, ThePadsOverrideCountsWhileThePadDrives) {
    m_input.setPad({0.2, 0.0, 0.0}, true, true);
    EXPECT_TRUE(m_input.withoutEyes());
    m_input.setPad({0.2, 0.0, 0.0}, true, false);
    EXPECT_FALSE(m_input.withoutEyes());
    m_input.setPad({0.2, 0.0, 0.0}, true, true);
    hold(Qt::Key_Space);
    EXPECT_FALSE(m_input.withoutEyes());
    m_input.setPad({}, false, true);
    EXPECT_FALSE(m_input.withoutEyes());
}

/// A window with a pane that floats beside it.
class FloatingPaneTest : public testing::Test {
protected:
    FloatingPaneTest() {
        QObject::connect(&m_input, &DriveInput::sticks,
                         [this](const DriveVelocity& velocity) { m_sticks = velocity; });
        m_input.setRobot(robot());
        auto* panes = new QMainWindow(&m_window, Qt::Widget);
        m_window.setCentralWidget(panes);
        m_dock = new QDockWidget("Pane", panes);
        m_dock->setWidget(new QWidget(m_dock));
        panes->addDockWidget(Qt::LeftDockWidgetArea, m_dock);
        m_dock->setFloating(true);
        m_window.show();
        m_dock->show();
        turnTo(m_window);
    }
    static void turnTo(QWidget& window) {
        window.activateWindow();
        // A child of the active window counts as active for qWaitForWindowActive().
        EXPECT_TRUE(QTest::qWaitFor([&window] { return QApplication::activeWindow() == &window; }));
    }

    QMainWindow m_window;
    QDockWidget* m_dock = nullptr;
    DriveInput m_input{m_window};
    DriveVelocity m_sticks;
};

TEST_F(FloatingPaneTest, ThePadDrivesOnBesideItAndKeysDoNot) {
    ASSERT_TRUE(m_dock->isWindow());
    EXPECT_TRUE(isWorkedIn(m_window));
    m_input.setPad({0.2, 0.0, 0.0}, true);
    turnTo(*m_dock);
    EXPECT_TRUE(isWorkedIn(m_window));
    EXPECT_TRUE(m_input.hasFocus());
    EXPECT_DOUBLE_EQ(m_sticks.forward, 0.2);
    m_input.setPad({}, false);
    turnTo(m_window);
    m_input.setFocus(true);
    turnTo(*m_dock);
    EXPECT_FALSE(m_input.hasFocus());
}

TEST_F(FloatingPaneTest, ADialogIsAnotherWindow) {
    m_input.setPad({0.2, 0.0, 0.0}, true);
    QWidget dialog(&m_window, Qt::Tool);
    dialog.show();
    turnTo(dialog);
    EXPECT_FALSE(isWorkedIn(m_window));
    EXPECT_FALSE(m_input.hasFocus());
    EXPECT_TRUE(isZero(m_sticks));
}

}  // namespace
}  // namespace leitstand::test
