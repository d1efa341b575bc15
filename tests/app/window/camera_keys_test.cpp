#include "app/window/panes/camera/camera_keys.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

class CameraKeysTest : public testing::Test {
protected:
    CameraKeysTest() {
        auto* rows = new QVBoxLayout(&m_window);
        rows->addWidget(&m_other);
        rows->addWidget(&m_text);
        m_other.setFocusPolicy(Qt::StrongFocus);
        QObject::connect(&m_keys, &CameraKeys::rateWanted,
                         [this](const PanTiltAngles& rate) { m_rate = rate; });
        m_window.show();
        m_window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&m_window));
        m_other.setFocus();
    }
    void hold(int key, Qt::KeyboardModifiers with = {}) {
        QTest::keyPress(&m_other, static_cast<Qt::Key>(key), with);
    }
    void letGo(int key, Qt::KeyboardModifiers with = {}) {
        QTest::keyRelease(&m_other, static_cast<Qt::Key>(key), with);
    }

    QWidget m_window;
    QWidget m_other{&m_window};
    QLineEdit m_text{&m_window};
    bool m_driving = false;
    CameraKeys m_keys{m_window, [this] { return m_driving; }};
    PanTiltAngles m_rate;
};

TEST_F(CameraKeysTest, TurnWhileTheyAreHeld) {
    hold(Qt::Key_Q);
    EXPECT_GT(m_rate.pan, 0.0) << "to the left";
    hold(Qt::Key_PageDown);
    EXPECT_GT(m_rate.tilt, 0.0) << "down";
    letGo(Qt::Key_Q);
    EXPECT_EQ(m_rate.pan, 0.0);
    hold(Qt::Key_E);
    EXPECT_LT(m_rate.pan, 0.0);
    hold(Qt::Key_Q);
    EXPECT_EQ(m_rate.pan, 0.0) << "both are none";
    for (const int key : {Qt::Key_Q, Qt::Key_E, Qt::Key_PageDown}) letGo(key);
    EXPECT_EQ(m_rate, PanTiltAngles{});
    const double fast = (hold(Qt::Key_Q), m_rate.pan);
    letGo(Qt::Key_Q);
    hold(Qt::Key_Q, Qt::ShiftModifier);
    EXPECT_LT(m_rate.pan, 0.5 * fast);
    EXPECT_GT(m_rate.pan, 0.0);
}

TEST_F(CameraKeysTest, TheNumberPadTurnsAndRecentresButDigitsDoNot) {
    QSignalSpy centred(&m_keys, &CameraKeys::recentreWanted);
    hold(Qt::Key_4);
    EXPECT_EQ(m_rate, PanTiltAngles{});
    hold(Qt::Key_4, Qt::KeypadModifier);
    EXPECT_GT(m_rate.pan, 0.0);
    letGo(Qt::Key_4, Qt::KeypadModifier);
    hold(Qt::Key_Left);
    EXPECT_EQ(m_rate, PanTiltAngles{}) << "arrows drive";
    hold(Qt::Key_5, Qt::KeypadModifier);
    EXPECT_EQ(centred.size(), 1);
}

TEST_F(CameraKeysTest, WithControlOnlyWhileItDrivesFast) {
    hold(Qt::Key_Q, Qt::ControlModifier);
    EXPECT_EQ(m_rate, PanTiltAngles{});
    m_driving = true;
    hold(Qt::Key_Q, Qt::ControlModifier);
    EXPECT_GT(m_rate.pan, 0.0);
    letGo(Qt::Key_Q);
    EXPECT_EQ(m_rate, PanTiltAngles{});
}

TEST_F(CameraKeysTest, AreLettersWhereTextIsTyped) {
    m_text.setFocus();
    QTest::keyClicks(&m_text, QStringLiteral("qe"));
    EXPECT_EQ(m_text.text(), QStringLiteral("qe"));
    EXPECT_EQ(m_rate, PanTiltAngles{});
}

TEST_F(CameraKeysTest, LeavingTheWindowLetsThemGo) {
    hold(Qt::Key_Q);
    ASSERT_GT(m_rate.pan, 0.0);
    QWidget other;
    other.show();
    other.activateWindow();
    EXPECT_TRUE(QTest::qWaitFor([&] { return m_rate == PanTiltAngles{}; }, 20'000));
}

}  // namespace
}  // namespace leitstand::test
