#include <QAction>
#include <QKeySequence>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "app/window/commands/command_table.h"
#include "app/window/review/timeline_feature.h"
#include "core/event/station_topics.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/review/written_mission.h"
#include "tests/app/window/review_page.h"
#include "widgets/timeline/timeline_bar.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;

/// A minute of a mission that kept a picture every three seconds, with victims, and hazards between them.
class ThinnedReview : public ReviewPage {
protected:
    void writeMission() override {
        Mission mission(m_mission);
        for (int i = 0; i <= 600; ++i) {
            const double t = 0.1 * i;
            mission.sayOdometry(t, 0.01 * i);
            if (i % 30 == 0) mission.sayPicture(t, 40 + i / 5);
            if (i % 20 == 0) mission.sayKeyScan(t, static_cast<std::uint64_t>(i / 20 + 1), 0.01 * i);
            if (i == 150) mission.sayVictim(t, 1, FindSample::Status::Confirmed);
            if (i == 250) hazard(mission, t);
            if (i == 350) mission.sayVictim(t, 2, FindSample::Status::Confirmed);
        }
    }
    static void hazard(Mission& mission, double seconds) {
        FindSample sign;
        sign.kind = FindSample::Kind::Hazard;
        sign.number = 1;
        sign.robot = "kurt3d";
        sign.stamp = sign.found = Mission::at(seconds);
        mission.publish(seconds, std::string(station_topic::Victims), sign);
    }
};

TEST_F(ThinnedReview, APictureIsOldOnlyWhenItIsOlderThanTheMissionsPicturesAre) {
    const FreshnessLimits limits = m_bridge->pictureLimits("kurt3d", "left");
    EXPECT_EQ(freshnessOf({.arrival = 2.9}, limits), Freshness::Live) << "the next one is not due yet";
    EXPECT_EQ(freshnessOf({.arrival = 9.0}, limits), Freshness::Stale);
    EXPECT_EQ(freshnessOf({.arrival = 20.0}, limits), Freshness::Lost);
    const MomentSource::ScanSource scan = m_bridge->scanSource("kurt3d");
    EXPECT_TRUE(scan.keyScans);
    EXPECT_EQ(freshnessOf({.arrival = 1.9}, scan.limits), Freshness::Live);
    EXPECT_EQ(m_bridge->pictureLimits("kurt3d", "nowhere").stale, FreshnessLimits().stale);
}

TEST_F(ThinnedReview, NextVictimStopsAtVictimsAloneAndHazardsHaveTheirOwn) {
    goTo(1.0);
    press(Qt::Key_F3);
    EXPECT_TRUE(stands(15.0));
    press(Qt::Key_F3);
    EXPECT_TRUE(stands(35.0)) << "the hazard between is none";
    press(Qt::Key_F3);
    EXPECT_TRUE(stands(15.0)) << "round and round";
    press(Qt::Key_H);
    EXPECT_TRUE(stands(25.0));
    press(Qt::Key_F3, Qt::ShiftModifier);
    EXPECT_TRUE(stands(15.0));
}

TEST_F(ThinnedReview, EveryKeyMeansOneThing) {
    std::map<QString, QStringList> meanings;
    for (const QAction* action : m_window->findChildren<QAction*>()) {
        for (const QKeySequence& keys : action->shortcuts()) meanings[keys.toString()] += action->text();
    }
    EXPECT_GT(meanings.size(), 30U);
    for (const auto& [keys, what] : meanings)
        EXPECT_EQ(what.size(), 1) << keys.toStdString() << ": " << what.join(", ").toStdString();
}

TEST_F(ThinnedReview, CommandsOfLiveWindowsHaveTheSameKeysHere) {
    const auto keysOf = [&](const char* id) {
        const QAction* const action = m_window->commands().find(QLatin1String(id));
        return action == nullptr ? std::string("none") : action->shortcut().toString().toStdString();
    };
    EXPECT_EQ(keysOf("review.confirm"), "V");
    EXPECT_EQ(keysOf("review.discard"), "Shift+Del");
    EXPECT_EQ(keysOf("review.move"), "Shift+V");
    EXPECT_EQ(keysOf("review.file"), "Shift+F");
    EXPECT_EQ(keysOf("review.undo"), "Ctrl+Shift+U");
    EXPECT_EQ(keysOf("cameraReset"), "Ctrl+Shift+R");
    EXPECT_EQ(keysOf("messages.open"), "F4");
}

}  // namespace
}  // namespace leitstand::test
