#include <QMessageBox>
#include <QPushButton>

#include <gtest/gtest.h>

#include "core/event/status_samples.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/robot_state.h"
#include "tests/app/live/live_page.h"
#include "tests/app/live/quiet_page.h"

namespace leitstand::test {
namespace {

/// What becomes of a robot that drives itself when its station is closed.
class Closing : public LivePage {
protected:
    [[nodiscard]] bool drivesItself() const {
        const auto mission = station().mission();
        const auto reported = mission->robots.find("kurt3d");
        return reported != mission->robots.end() && reported->second->mode &&
               reported->second->mode->sample.autonomous;
    }
    void explore() {
        station().requestGrant("kurt3d");
        ASSERT_TRUE(soon([&] { return robot().grant.mine; }));
        ASSERT_TRUE(soon([&] { return station().setMode("kurt3d", "explore").ok() && drivesItself(); }));
        // What the window shows is of its newest tick.
        ASSERT_TRUE(soon([&] {
            const LiveMoment& moment = m_bridge->moment();
            return moment.mission && moment.reported("kurt3d").mode &&
                   moment.reported("kurt3d").mode->sample.autonomous;
        }));
    }
    [[nodiscard]] QMessageBox* question() const {
        return m_window->findChild<QMessageBox*>(QStringLiteral("closingQuestion"));
    }
    void answer(const char* button) const {
        question()->findChild<QPushButton*>(QLatin1String(button))->click();
    }
};

TEST_F(Closing, ARobotThatDrivesItselfIsAskedFor) {
    ASSERT_NO_FATAL_FAILURE(explore());
    m_window->close();
    EXPECT_TRUE(m_window->isVisible()) << "closed without a question";
    ASSERT_NE(question(), nullptr);
    EXPECT_FALSE(question()->isModal());
    EXPECT_TRUE(question()->text().contains(QStringLiteral("Kurt3D"))) << question()->text().toStdString();
    lookAt("closing");
    answer("stay");
    EXPECT_TRUE(m_window->isVisible());
    ASSERT_TRUE(soon([&] { return question() == nullptr; }));
    EXPECT_TRUE(drivesItself()) << "nothing was done";

    m_window->close();
    ASSERT_NE(question(), nullptr);
    answer("leaveAndClose");
    EXPECT_FALSE(m_window->isVisible());
    EXPECT_FALSE(station().robot("kurt3d").stop.sent);
}

TEST_F(Closing, StoppedItStandsBeforeTheWindowCloses) {
    ASSERT_NO_FATAL_FAILURE(explore());
    m_window->close();
    ASSERT_NE(question(), nullptr);
    answer("stopAndClose");
    ASSERT_TRUE(soon([&] { return !m_window->isVisible(); }));
    EXPECT_TRUE(station().robot("kurt3d").stop.acknowledged);
    EXPECT_FALSE(station().robot("crawler").stop.sent) << "nobody asked for that";
}

TEST_F(Closing, EscStopsWhileItIsAsked) {
    ASSERT_NO_FATAL_FAILURE(explore());
    m_window->close();
    ASSERT_NE(question(), nullptr);
    ASSERT_TRUE(soon([&] { return question()->isVisible(); }));
    QTest::keyClick(question()->windowHandle(), Qt::Key_Escape);
    EXPECT_TRUE(soon([&] { return robot().stop.acknowledged; }));
    EXPECT_TRUE(question()->isVisible()) << "Esc stops, and answers nothing";
    answer("leaveAndClose");
    EXPECT_FALSE(m_window->isVisible());
}

TEST_F(Closing, WhereNobodyCanAnswerNobodyIsAsked) {
    ASSERT_NO_FATAL_FAILURE(explore());
    m_window->closeUnasked();
    EXPECT_FALSE(m_window->isVisible());
    EXPECT_EQ(question(), nullptr);
}

using ClosingQuietly = QuietPage;

TEST_F(ClosingQuietly, NoRobotThatDrivesItselfIsNoQuestion) {
    window().close();
    EXPECT_FALSE(window().isVisible());
}

}  // namespace
}  // namespace leitstand::test
