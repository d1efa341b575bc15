#include <algorithm>
#include <chrono>

#include <gtest/gtest.h>
#include <QListView>
#include <QToolButton>

#include "app/services/station/safety/station_alarms.h"
#include "tests/app/live/live_page.h"

namespace leitstand::test {
namespace {

class LiveAlarms : public LivePage {
protected:
    [[nodiscard]] AlarmsView alarms() const { return station().alarms().view(); }
    [[nodiscard]] bool isLost(const char* name) const {
        const auto all = alarms().alarms;
        return std::any_of(all.begin(), all.end(), [name](const Alarm& one) {
            return one.cause.id == AlarmId{name, alarm_key::LinkLost, ""};
        });
    }
};

TEST_F(LiveAlarms, LostRobotsAreToldAcknowledgedAndMuted) {
    ASSERT_TRUE(soon([&] {
        return robot().link.state == LinkState::Connected &&
               robot("crawler").link.state == LinkState::Connected;
    }));
    m_robots.reset();
    ASSERT_TRUE(soon([&] { return isLost("kurt3d") && isLost("crawler"); }));
    auto* list = m_window->findChild<QListView*>(QStringLiteral("alarms"));
    ASSERT_NE(list, nullptr);
    EXPECT_TRUE(soon([&] { return list->model()->rowCount() >= 2; }));
    EXPECT_TRUE(list->isVisible()) << "the layout for driving shows alarms";
    press(Qt::Key_M);
    EXPECT_GT(alarms().mutedUntil, m_bridge->moment().now + std::chrono::seconds(50));
    EXPECT_TRUE(soon([&] {
        return m_window->findChild<QToolButton*>(QStringLiteral("mute"))
            ->text()
            .contains(QStringLiteral("muted for"));
    }));
    press(Qt::Key_M);
    EXPECT_LE(alarms().mutedUntil, m_bridge->moment().now + std::chrono::seconds(1));
    EXPECT_TRUE(alarms().loud);
    for (int i = 0; i < 20 && alarms().loud; ++i) press(Qt::Key_Backspace);
    EXPECT_FALSE(alarms().loud);
}

}  // namespace
}  // namespace leitstand::test
