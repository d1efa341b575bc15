#include <cmath>
#include <filesystem>

#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/services/finds/find_desk.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/selection.h"
#include "app/window/layouts/layout_feature.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"
#include "tests/app/live/live_page.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/mission/mission_form.h"
#include "widgets/victims/victim_form.h"
#include "widgets/virtual_scan/virtual_scan_pane.h"

namespace leitstand::test {
namespace {

using Kind = FindSample::Kind;
using Status = FindSample::Status;

/// Finds on robots that are processes, through the real widgets.
class LiveVictims : public LivePage {
protected:
    LiveVictims() {
        m_window->layouts().use("map");
        EXPECT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    }
    void trigger(const char* id) {
        QAction* const action = m_window->commands().find(id);
        ASSERT_NE(action, nullptr) << id;
        action->trigger();
    }
    [[nodiscard]] const FindState* victim(std::uint32_t number, Kind kind = Kind::Victim) {
        m_mission = station().mission();
        const auto found = m_mission->finds->find({kind, number});
        return found == m_mission->finds->end() ? nullptr : &found->second;
    }
    [[nodiscard]] bool is(std::uint32_t number, Status status) {
        const FindState* one = victim(number);
        return one != nullptr && one->victim.status == status;
    }

private:
    MissionStatePtr m_mission;
};

TEST_F(LiveVictims, OneKeyFreezesAnotherConfirmsTheFormFollowsAndARestartKeepsAll) {
    press(Qt::Key_F);
    ASSERT_TRUE(soon([&] { return victim(1) != nullptr; })) << m_window->newest().toStdString();
    const FindSample filed = victim(1)->victim;
    EXPECT_EQ(filed.robot, "kurt3d");
    EXPECT_NE(filed.scan, 0U) << "it hangs on a scan and moves with it";
    EXPECT_LT((filed.positionInMap).head<2>().norm(), 12.0);
    const auto shows = [&](const std::string& kind) {
        return std::any_of(filed.evidence.begin(), filed.evidence.end(),
                           [&](const VictimEvidence& one) { return one.kind == kind && one.sequence > 0; });
    };
    for (const char* kind : {"picture", "thermal", "gas", "scan", "odometry"})
        EXPECT_TRUE(shows(kind)) << kind;
    auto* table = m_window->findChild<QTableView*>("finds");
    ASSERT_NE(table, nullptr);
    ASSERT_TRUE(soon([&] { return table->model()->rowCount() >= 1 && table->currentIndex().isValid(); }));
    press(Qt::Key_V);
    ASSERT_TRUE(soon([&] { return is(1, Status::Confirmed); }));

    m_window->panes().open(QStringLiteral("form"));
    auto* form = m_window->findChild<VictimForm*>("formPane");
    ASSERT_NE(form, nullptr);
    ASSERT_TRUE(soon([&] { return form->isVisible(); }));
    const auto box = [&](const char* name) {
        for (QComboBox* one : form->findChildren<QComboBox*>()) {
            if (one->accessibleName() == QLatin1String(name)) return one;
        }
        return static_cast<QComboBox*>(nullptr);
    };
    ASSERT_TRUE(soon([&] { return box("Situation")->isEnabled(); }));
    box("Situation")->setCurrentIndex(3);
    box("Sound")->setCurrentIndex(1);
    ASSERT_TRUE(soon([&] { return victim(1)->victim.situation == "void"; }));
    ASSERT_TRUE(soon([&] { return victim(1)->victim.sound.state == VictimSign::State::Absent; }));
    lookAt("victims_map");
    m_window->layouts().use("drive");
    lookAt("victims_drive");

    restart();
    ASSERT_TRUE(soon([&] { return is(1, Status::Confirmed); })) << "nothing is lost";
    EXPECT_EQ(victim(1)->victim.situation, "void");
    trigger("victim.undo");
    ASSERT_TRUE(soon([&] { return victim(1)->victim.sound.state != VictimSign::State::Absent; }))
        << "undo goes on after a restart";
}

TEST_F(LiveVictims, HazardsAreFiledPlacedMergedAndDiscarded) {
    trigger("victim.hazard");
    ASSERT_TRUE(soon([&] { return victim(1, Kind::Hazard) != nullptr; })) << m_window->newest().toStdString();
    EXPECT_EQ(victim(1), nullptr) << "numbers of hazards are their own";
    station().finds().freezeAt("kurt3d", Kind::Victim, {1.0, 0.0, 0.2});
    station().finds().freezeAt("kurt3d", Kind::Victim, {2.5, 0.0, 0.2});
    ASSERT_TRUE(soon([&] { return victim(2) != nullptr; }));
    auto* table = m_window->findChild<QTableView*>("finds");
    const auto row = [&](const char* name) {
        for (int i = 0; i < table->model()->rowCount(); ++i) {
            if (table->model()->index(i, 0).data().toString() == QLatin1String(name)) return i;
        }
        return -1;
    };
    ASSERT_TRUE(soon([&] { return row("V2") >= 0; }));
    station().finds().freezeAt("kurt3d", Kind::Victim, {6.0, 0.0, 0.2});
    ASSERT_TRUE(soon([&] { return row("V3") >= 0; }));
    table->selectRow(row("V3"));
    trigger("victim.merge");
    EXPECT_TRUE(m_window->newest().contains("V2")) << "it is told how far the nearest is";
    EXPECT_TRUE(m_window->newest().contains("3.5 m")) << m_window->newest().toStdString();
    table->selectRow(row("V2"));
    trigger("victim.merge");
    ASSERT_TRUE(soon([&] { return victim(2)->victim.mergedInto == 1; }));
    ASSERT_TRUE(soon([&] { return row("V2") < 0; })) << "it is part of V1";
    EXPECT_EQ(victim(3)->victim.mergedInto, 0U) << "too far away to be the same";
    ASSERT_TRUE(soon([&] { return row("H1") >= 0; }));
    table->selectRow(row("H1"));
    trigger("victim.discard");
    ASSERT_TRUE(soon([&] { return victim(1, Kind::Hazard)->victim.status == Status::Discarded; }));
    trigger("victim.undo");
    ASSERT_TRUE(soon([&] { return victim(1, Kind::Hazard)->victim.status == Status::Hypothesis; }));
}

TEST_F(LiveVictims, AreFiledWhereTheOperatorPoints) {
    m_window->layouts().use("drive");
    auto* const large = m_window->findChild<CameraPane*>("cameraPane");
    ASSERT_NE(large, nullptr);
    ASSERT_TRUE(soon([&] { return !large->pictureArea().isEmpty(); }));
    // Below the horizon, where there is floor or what stands on it.
    const QRectF area = large->pictureArea();
    QTest::mouseClick(large, Qt::LeftButton, Qt::ShiftModifier,
                      QPointF(area.left() + 0.3 * area.width(), area.top() + 0.6 * area.height()).toPoint());
    ASSERT_TRUE(soon([&] { return victim(1) != nullptr; })) << m_window->newest().toStdString();
    EXPECT_FALSE(m_window->driving()) << "that click is not for driving";
    const FindSample pictured = victim(1)->victim;
    Eigen::Vector3d seen = pictured.positionInMap;
    Pose base = Pose::Identity();
    const RobotsInMapPtr robots = station().mapping().robots();
    for (const RobotInMap& one : *robots) {
        if (one.robot == "kurt3d") base = one.baseInMap;
    }
    seen = base.inverse() * seen;
    EXPECT_GT(seen.x(), 0.2) << "ahead";
    EXPECT_GT(seen.y(), 0.0) << "and to the left: " << seen.transpose();

    auto* const around = m_window->findChild<VirtualScanPane*>();
    ASSERT_NE(around, nullptr);
    ASSERT_TRUE(soon([&] { return around->isVisible(); }));
    trigger("victim.point");
    EXPECT_EQ(around->cursor().shape(), Qt::CrossCursor);
    EXPECT_EQ(large->cursor().shape(), Qt::CrossCursor);
    QTest::mouseClick(around, Qt::LeftButton, {}, around->pixelOf({-1.2, -0.9}).toPoint());
    ASSERT_TRUE(soon([&] { return victim(2) != nullptr; })) << m_window->newest().toStdString();
    const Eigen::Vector3d behind = base.inverse() * victim(2)->victim.positionInMap;
    EXPECT_LT((behind.head<2>() - Eigen::Vector2d(-1.2, -0.9)).norm(), 0.1) << behind.transpose();
    EXPECT_FALSE(m_window->commands().find("victim.point")->isChecked());
    EXPECT_NE(around->cursor().shape(), Qt::CrossCursor) << "one click, one victim";

    trigger("victim.point");
    QTest::mouseClick(around, Qt::RightButton, {}, around->pixelOf({1.0, 0.0}).toPoint());
    EXPECT_FALSE(m_window->commands().find("victim.point")->isChecked()) << "at nothing";
    EXPECT_EQ(victim(3), nullptr);

    trigger("victim.point");
    m_window->selection().select("crawler");
    EXPECT_FALSE(m_window->commands().find("victim.point")->isChecked())
        << "what was seen was the other one's";
    EXPECT_NE(large->cursor().shape(), Qt::CrossCursor);
    QTest::mouseClick(around, Qt::LeftButton, {}, around->pixelOf({-1.2, -0.9}).toPoint());
    EXPECT_EQ(station().finds().filings(), 2U);
}

TEST_F(LiveVictims, WhatIsWrittenIntoTheFormDrivesNobody) {
    press(Qt::Key_F);
    m_window->panes().open(QStringLiteral("form"));
    auto* form = m_window->findChild<VictimForm*>("formPane");
    ASSERT_NE(form, nullptr);
    QLineEdit* field = nullptr;
    ASSERT_TRUE(soon([&] {
        for (QLineEdit* one : form->findChildren<QLineEdit*>()) {
            if (one->isVisible() && one->isEnabled()) field = one;
        }
        return field != nullptr;
    }));
    press(Qt::Key_F2);
    ASSERT_TRUE(soon([&] { return mayDrive(); }));
    field->setFocus();
    EXPECT_FALSE(m_window->driving());
    QTest::keyPress(field, Qt::Key_W);
    EXPECT_FALSE(QTest::qWaitFor([&] { return std::abs(speed()) > 0.02; }, 1'000));
    QTest::keyRelease(field, Qt::Key_W);
    EXPECT_TRUE(field->text().endsWith(QLatin1Char('w'))) << field->text().toStdString();
}

TEST_F(LiveVictims, MissionDataAreAskedForWithoutStoppingAnything) {
    trigger("mission.data");
    auto* form = m_window->findChild<MissionForm*>("missionForm");
    ASSERT_NE(form, nullptr);
    EXPECT_FALSE(form->isModal());
    for (QLineEdit* line : form->findChildren<QLineEdit*>()) {
        if (line->accessibleName() == QStringLiteral("Team")) line->setText(QStringLiteral("Osnabrück"));
    }
    emit form->wanted(form->info());
    ASSERT_TRUE(soon([&] { return station().mission()->info != nullptr; }));
    EXPECT_EQ(station().mission()->info->sample.team, "Osnabrück");
    EXPECT_EQ(station().mission()->info->sample.profile, "2019")
        << "the newest rules, until others are chosen";
}

}  // namespace
}  // namespace leitstand::test
