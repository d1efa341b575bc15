#include "tests/app/reach.h"

#include <vector>

#include <QAction>
#include <QApplication>
#include <QListView>
#include <QPointer>
#include <QTableView>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/window/layouts/layout_feature.h"
#include "tests/app/live/eventful.h"
#include "tests/app/live/quiet_page.h"
#include "widgets/mission/clock_face.h"

namespace leitstand::test {
namespace {

using testing::IsEmpty;
using LiveReach = QuietPage;

TEST_F(LiveReach, EverythingInEveryLayoutHasANameAndIsReachedByKeys) {
    const auto* const clock = window().findChild<ClockFace*>();
    ASSERT_NE(clock, nullptr);
    ASSERT_TRUE(soon([&] { return !clock->toolTip().isEmpty(); })) << "the window shows what is";
    for (const char* layout : {"drive", "explore", "map", "review", "link", "report"}) {
        ASSERT_TRUE(window().layouts().use(QLatin1String(layout)));
        QApplication::processEvents();
        EXPECT_GT(thingsToUse(window()), 10) << layout;
        EXPECT_THAT(outOfReach(window()), IsEmpty()) << layout;
    }
}

TEST_F(LiveReach, AlarmsFindsAndStoppedRobotsAreReachedByKeysToo) {
    ASSERT_TRUE(makeEventful(station(), [](auto holds) { return soon(holds); }));
    const auto* const finds = window().findChild<QTableView*>(QStringLiteral("finds"));
    const auto* const alarms = window().findChild<QListView*>(QStringLiteral("alarms"));
    ASSERT_TRUE(finds != nullptr && alarms != nullptr);
    ASSERT_TRUE(soon([&] { return finds->model()->rowCount() >= 5 && alarms->model()->rowCount() >= 2; }));
    for (const char* layout : {"drive", "map", "report"}) {
        ASSERT_TRUE(window().layouts().use(QLatin1String(layout)));
        QApplication::processEvents();
        EXPECT_THAT(outOfReach(window()), IsEmpty()) << layout;
    }
}

TEST_F(LiveReach, EverythingInEveryDialogHasANameAndIsReachedByKeys) {
    for (const char* id : {"keys", "about", "preflight.open", "mission.length", "mission.data", "layout.save",
                           "pad.controls"}) {
        command(id).trigger();
        int dialogs = 0;
        std::vector<QPointer<QWidget>> tops;  // a dialog that is closed takes its own with it
        for (QWidget* top : QApplication::topLevelWidgets()) tops.emplace_back(top);
        for (const QPointer<QWidget>& top : tops) {
            if (!top || top == &window() || !top->isVisible() || top->parentWidget() == nullptr) continue;
            top->activateWindow();
            ASSERT_TRUE(QTest::qWaitForWindowActive(top)) << id;
            EXPECT_GT(thingsToUse(*top), 0) << id;
            EXPECT_THAT(outOfReach(*top), IsEmpty()) << id;
            top->close();
            ++dialogs;
        }
        EXPECT_EQ(dialogs, 1) << id;
    }
}

}  // namespace
}  // namespace leitstand::test
