// Readings of a stock robot in the window: values, plot, alarm.
#include <memory>
#include <string>
#include <vector>

#include <QAction>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/services/station/safety/station_alarms.h"
#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/source/moment_source.h"
#include "core/event/stream_role.h"
#include "core/station/alarms/alarm.h"
#include "tests/app/live/live_page.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "widgets/readings/readings_panel.h"

namespace leitstand::test {
namespace {

class ReadingsPage : public LivePage {
protected:
    ReadingsPage() : LivePage(Robots::None, {described()}) {
        m_robot = std::make_unique<ChildProcess>(
            program("leitstand-robot"),
            std::vector<std::string>{"stock", "tracked", "--domain", std::to_string(m_domain.number()),
                                     "--arena", "yellow", "--seed", "7"});
        m_window->commands().find(QStringLiteral("readings.open"))->trigger();
        m_panel = m_window->findChild<ReadingsPanel*>();
        m_table = m_panel->findChild<QTableView*>(QStringLiteral("readings"));
    }
    /// With a limit that the air of the arena is beyond.
    static RobotDescription described() {
        RobotDescription robot = shippedRobot("tracked");
        for (StreamDescription& stream : robot.streams) {
            if (stream.topic == "/temperature") stream.readings.at(0).limits = {{}, 15.0, {}, {}};
        }
        return robot;
    }
    [[nodiscard]] QString cell(int row, int column) const {
        return m_table->model()->index(row, column).data().toString();
    }

    std::unique_ptr<ChildProcess> m_robot;
    ReadingsPanel* m_panel = nullptr;
    QTableView* m_table = nullptr;
};

TEST_F(ReadingsPage, ShowsNumbersTheirTrendAndWhatIsBeyondItsLimits) {
    ASSERT_TRUE(soon([&] { return cell(0, ReadingRowsModel::Value).endsWith(QStringLiteral("°C")); }))
        << cell(0, ReadingRowsModel::Value).toStdString();
    EXPECT_EQ(cell(0, ReadingRowsModel::Title), QStringLiteral("Air"));
    EXPECT_TRUE(cell(0, ReadingRowsModel::Value).startsWith(QStringLiteral("2"))) << "22 degrees";
    EXPECT_TRUE(soon([&] { return cell(1, ReadingRowsModel::Value).endsWith(QStringLiteral(" m")); }))
        << cell(1, ReadingRowsModel::Value).toStdString();
    EXPECT_TRUE(soon([&] {
        for (const Alarm& alarm : station().alarms().view().alarms) {
            if (alarm.cause.id == AlarmId{"tracked", alarm_key::Reading, "Air"}) return true;
        }
        return false;
    }));
    EXPECT_TRUE(soon([&] { return station().mission()->robots.at("tracked")->readings.size() == 2; }))
        << "the mission knows them";
    QTest::qWait(3000);
    lookAt("readings");
}

}  // namespace
}  // namespace leitstand::test
