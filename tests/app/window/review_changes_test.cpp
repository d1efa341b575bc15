#include <string>

#include <gmock/gmock.h>
#include <QAction>
#include <QTableView>

#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "core/event/map_samples.h"
#include "core/event/scan_pose.h"
#include "core/event/station_topics.h"
#include "tests/app/review/written_mission.h"
#include "tests/app/window/review_page.h"
#include "tests/support/visits.h"
#include "widgets/map_view/map_view.h"
#include "widgets/map_view/scene/points/map_colours.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// What a station said of the key scans of @p visit.
void publish(WrittenMission& mission, const RoomVisit& visit) {
    for (const ReportScan& scan : scansOf(visit)) {
        const auto seconds = static_cast<double>(scan.id);
        KeyScanSample key;
        key.stamp = WrittenMission::at(seconds);
        key.id = scan.id;
        key.scan = scan.scan;
        key.scanInMap = scan.scanInMap;
        mission.publish(seconds, std::string(station_topic::KeyScans), key);
        ScanPose pose;
        pose.scan = scan.id;
        pose.scanInMap = scan.scanInMap;
        mission.publish(seconds, std::string(station_topic::ScanPoses),
                        ScanPosesSample{key.stamp, "us", ScanPosesSample::Cause::Registration, {pose}});
    }
}

/// A map of two days: furniture came in between.
class ReviewChanges : public ReviewPage {
protected:
    void writeMission() override {
        WrittenMission mission(m_mission);
        publish(mission, {"kurt3d@monday", 0, false, 1});
        if (twoDays()) publish(mission, {"kurt3d@tuesday", 1, true, 4});
        mission.sayOdometry(8.0, 0.0);
    }
    [[nodiscard]] virtual bool twoDays() const { return true; }
    [[nodiscard]] QAction& command(const char* id) const { return *m_window->commands().find(id); }
};
class ReviewOfOneDay : public ReviewChanges {
protected:
    [[nodiscard]] bool twoDays() const override { return false; }
};

TEST_F(ReviewChanges, WhatCameIsListedAndTheMapShowsWhere) {
    goTo(8.0);
    ASSERT_TRUE(soon([this] { return command("changes.show").isEnabled(); }));
    const Rgba orange = mapColours(Theme::Dark).newThing;
    const auto coloured = [&] {
        const QImage picture = m_window->mapView().grab().toImage();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x)
                count += picture.pixel(x, y) == qRgb(orange.r, orange.g, orange.b) ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(coloured(), 0);
    command("changes.show").trigger();
    EXPECT_TRUE(m_window->panes().isPaneVisible("changes"));
    auto& list = find<QTableView>("changes");
    ASSERT_TRUE(soon([&] { return list.model()->rowCount() > 0; }));
    EXPECT_THAT(label("changesTitle"), StartsWith("monday → tuesday: new "));
    EXPECT_THAT(label("changesTitle"), HasSubstr("gone 0"));
    for (int row = 0; row < list.model()->rowCount(); ++row)
        EXPECT_EQ(list.model()->index(row, 1).data().toString(), "new") << row;
    lookAt("changes");
    EXPECT_TRUE(soon([&] { return coloured() > 300; })) << "more than the legend's square";
    list.selectRow(0);
    command("changes.place").trigger();
    command("changes.show").trigger();
    EXPECT_TRUE(soon([&] { return coloured() == 0; }));
}

TEST_F(ReviewChanges, AtAMomentBeforeTheSecondDayThereIsNothingToCompare) {
    goTo(8.0);
    ASSERT_TRUE(soon([this] { return command("changes.show").isEnabled(); }));
    command("changes.show").trigger();
    goTo(3.5);
    EXPECT_TRUE(soon([this] { return !command("changes.show").isEnabled(); }));
    EXPECT_FALSE(command("changes.show").isChecked());
    EXPECT_TRUE(soon([this] { return find<QTableView>("changes").model()->rowCount() == 0; }));
}

TEST_F(ReviewOfOneDay, HasNothingToCompare) {
    goTo(8.0);
    EXPECT_TRUE(soon([this] { return label("mapTitle").find("3 key scans") != std::string::npos; }));
    EXPECT_FALSE(command("changes.show").isEnabled());
}

}  // namespace
}  // namespace leitstand::test
