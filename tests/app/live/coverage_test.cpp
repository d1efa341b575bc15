#include <QAction>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "core/mission/coverage/searched_floor.h"
#include "tests/app/live/live_page.h"

namespace leitstand::test {
namespace {

/// What was searched, with robots that are processes.
class LiveCoverage : public LivePage {
protected:
    void trigger(const char* id) {
        QAction* const action = m_window->commands().find(id);
        ASSERT_NE(action, nullptr) << id;
        action->trigger();
    }
    [[nodiscard]] double seen(SearchSensor sensor) const {
        const auto searched = station().searched();
        return searched ? searched->by(sensor).seen : 0.0;
    }
};

TEST_F(LiveCoverage, WhatCamerasAndScannerLookAtIsKnownAndWhatTheyMissedIsListed) {
    ASSERT_TRUE(soon([&] { return seen(SearchSensor::Scanner) > 0.5; }));
    ASSERT_TRUE(soon([&] { return seen(SearchSensor::Camera) > 0.2; }));
    ASSERT_TRUE(soon([&] { return seen(SearchSensor::Infrared) > 0.2; }));
    EXPECT_LE(seen(SearchSensor::Camera), station().searched()->reachable);
    trigger("coverage.next");
    EXPECT_TRUE(m_window->commands().find("coverage.scanner")->isChecked());
    trigger("coverage.next");
    EXPECT_TRUE(m_window->commands().find("coverage.camera")->isChecked());
    trigger("coverage.missed");
    EXPECT_TRUE(m_window->panes().isPaneVisible("missed"));
    auto* table = m_window->findChild<QTableView*>("missed");
    ASSERT_NE(table, nullptr);
    EXPECT_TRUE(soon([&] { return table->model()->rowCount() > 0; })) << "behind a robot nothing was seen";
    lookAt("coverage");
    trigger("coverage.off");
    EXPECT_TRUE(m_window->commands().find("coverage.off")->isChecked());
}

}  // namespace
}  // namespace leitstand::test
