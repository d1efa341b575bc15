#include <QAction>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/services/finds/find_desk.h"
#include "app/services/log/live_mission.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/layouts/layout_feature.h"
#include "core/event/station_topics.h"
#include "core/mission/finds/dismissal.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"
#include "tests/app/live/live_page.h"
#include "widgets/map_view/map_view.h"
#include "widgets/virtual_scan/virtual_scan_pane.h"

namespace leitstand::test {
namespace {

using Kind = FindSample::Kind;

/// Finds and candidates that are moved, pointed to and dismissed, through the real widgets.
class LiveFindPlacing : public LivePage {
protected:
    void use(const char* layout) {
        m_window->layouts().use(layout);
        ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
        ASSERT_TRUE(soon([&] { return place().placed; })) << "no scan was registered";
    }
    void trigger(const char* id) {
        QAction* const action = m_window->commands().find(id);
        ASSERT_NE(action, nullptr) << id;
        action->trigger();
    }
    [[nodiscard]] RobotInMap place() const {
        const RobotsInMapPtr robots = station().mapping().robots();
        for (const RobotInMap& one : *robots) {
            if (one.robot == "kurt3d") return one;
        }
        return {};
    }
    [[nodiscard]] std::optional<Eigen::Vector3d> placeOf(Kind kind, std::uint32_t number) const {
        const MissionStatePtr mission = station().mission();
        const auto found = mission->finds->find({kind, number});
        if (found == mission->finds->end()) return std::nullopt;
        return positionInMap(*mission, found->second.victim);
    }
    /// Row of the list whose column @p column begins so; -1: none.
    [[nodiscard]] int row(const char* text, int column = 0) const {
        const auto* table = m_window->findChild<QTableView*>("finds");
        for (int i = 0; i < table->model()->rowCount(); ++i) {
            if (table->model()->index(i, column).data().toString().startsWith(QLatin1String(text))) return i;
        }
        return -1;
    }
    void choose(int row) { m_window->findChild<QTableView*>("finds")->selectRow(row); }
    /// Ends the station, lets the log say @p candidate, and resumes the mission.
    void believe(const CandidateSample& candidate) {
        restart([&] {
            LiveMissionSettings settings;
            settings.folder = std::filesystem::path(m_folder.path().toStdString()) / "mission";
            settings.robots.push_back(shippedRobot("kurt3d"));
            const auto mission = LiveMission::open(settings);
            ASSERT_TRUE(mission) << mission.error().text;
            ASSERT_TRUE((*mission)->record(candidate, station_topic::Candidates));
            ASSERT_TRUE((*mission)->close());
        });
    }
};

TEST_F(LiveFindPlacing, AFindIsMovedByAClickOnTheMapAndUndoPutsItBack) {
    use("map");
    trigger("map.followAbove");
    const Eigen::Vector3d first = place().baseInMap * Eigen::Vector3d(0.6, 0.5, 0.2);
    const Eigen::Vector3d then = place().baseInMap * Eigen::Vector3d(0.9, -0.4, 0.0);
    station().finds().freezeAt("kurt3d", Kind::Victim, first);
    ASSERT_TRUE(soon([&] { return row("V1") >= 0; }));
    choose(row("V1"));
    MapView& map = m_window->mapView();
    ASSERT_TRUE(soon([&] {
        const auto at = map.project(then);
        return at && map.rect().contains(at->toPoint()) && map.settled();
    }));
    trigger("victim.move");
    EXPECT_TRUE(map.drawing());
    QTest::mouseClick(&map, Qt::LeftButton, {}, map.project(then)->toPoint());
    EXPECT_FALSE(map.drawing());
    EXPECT_FALSE(m_window->commands().find("victim.move")->isChecked());
    const auto away = [&](const Eigen::Vector3d& from) {
        return (*placeOf(Kind::Victim, 1) - from).head<2>().norm();
    };
    EXPECT_TRUE(soon([&] { return away(then) < 0.2; })) << away(then) << " m off";
    EXPECT_EQ(placeOf(Kind::Victim, 2), std::nullopt) << "moved, not filed once more";
    trigger("victim.undo");
    EXPECT_TRUE(soon([&] { return away(first) < 0.1; })) << away(first) << " m off";
}

TEST_F(LiveFindPlacing, AVictimIsFiledByAClickOnTheMap) {
    use("map");
    trigger("map.followAbove");
    const Eigen::Vector3d there = place().baseInMap * Eigen::Vector3d(0.8, -0.4, 0.0);
    MapView& map = m_window->mapView();
    ASSERT_TRUE(soon([&] {
        const auto at = map.project(there);
        return at && map.rect().contains(at->toPoint()) && map.settled();
    }));
    trigger("victim.point");
    QTest::mouseClick(&map, Qt::LeftButton, {}, map.project(there)->toPoint());
    ASSERT_TRUE(soon([&] { return placeOf(Kind::Victim, 1).has_value(); }));
    EXPECT_LT((*placeOf(Kind::Victim, 1) - there).head<2>().norm(), 0.2);
    EXPECT_FALSE(m_window->commands().find("victim.point")->isChecked()) << "one click, one find";
}

TEST_F(LiveFindPlacing, WhatIsPointedToIsOfTheKindThatTheCommandSays) {
    use("drive");
    auto* const around = m_window->findChild<VirtualScanPane*>();
    ASSERT_NE(around, nullptr);
    ASSERT_TRUE(soon([&] { return around->isVisible(); }));
    const auto point = [&](const char* command) {
        trigger(command);
        EXPECT_EQ(around->cursor().shape(), Qt::CrossCursor) << command;
        QTest::mouseClick(around, Qt::LeftButton, {}, around->pixelOf({-1.2, -0.9}).toPoint());
        EXPECT_FALSE(m_window->commands().find(command)->isChecked()) << command << ": one click, one find";
    };
    point("victim.pointHazard");
    EXPECT_TRUE(soon([&] { return placeOf(Kind::Hazard, 1).has_value(); }));
    point("victim.pointCode");
    EXPECT_TRUE(soon([&] { return placeOf(Kind::Code, 1).has_value(); }));
    point("victim.pointObject");
    EXPECT_TRUE(soon([&] { return placeOf(Kind::Object, 1).has_value(); }));
    EXPECT_FALSE(placeOf(Kind::Victim, 1)) << "none of them is one";
    trigger("victim.pointHazard");
    trigger("victim.point");
    EXPECT_FALSE(m_window->commands().find("victim.pointHazard")->isChecked()) << "the last one counts";
    EXPECT_EQ(around->cursor().shape(), Qt::CrossCursor);
    QTest::mouseClick(around, Qt::LeftButton, {}, around->pixelOf({1.2, 0.9}).toPoint());
    EXPECT_TRUE(soon([&] { return placeOf(Kind::Victim, 1).has_value(); }));
    EXPECT_NE(around->cursor().shape(), Qt::CrossCursor);
}

TEST_F(LiveFindPlacing, ACandidateIsDismissedByKeyAndUndoBringsItBack) {
    CandidateSample candidate;
    candidate.stamp = Time(std::chrono::seconds(1));
    candidate.station = "an earlier one";
    candidate.id = 900;
    candidate.kind = Kind::Object;  // none is found by the station itself
    candidate.positionInMap = {3.0, 3.0, 0.2};
    candidate.deviation = 0.1;
    candidate.confidence = 0.9;
    candidate.cues = {{.kind = "hazard", .robot = "kurt3d", .confidence = 0.9, .text = "box"}};
    ASSERT_NO_FATAL_FAILURE(believe(candidate));
    m_window->layouts().use("map");
    ASSERT_TRUE(soon([&] { return row("object, candidate", 1) >= 0; }));
    choose(row("object, candidate", 1));
    QTest::keyClick(m_window.get(), Qt::Key_Delete, Qt::ShiftModifier);
    const auto reported = [&] { return station().mission()->candidates->at(900).candidate; };
    ASSERT_TRUE(soon([&] { return isDismissal(reported()); })) << m_window->newest().toStdString();
    ASSERT_TRUE(soon([&] { return row("object, candidate", 1) < 0; }));
    EXPECT_TRUE(station().mission()->finds->empty()) << "nothing was filed";
    trigger("victim.undo");
    EXPECT_TRUE(soon([&] { return row("object, candidate", 1) >= 0; }));
}

}  // namespace
}  // namespace leitstand::test
