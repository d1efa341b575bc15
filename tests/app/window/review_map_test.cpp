#include "tests/app/window/review_page.h"

#include <memory>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include "app/window/commands/command_table.h"
#include "app/window/review/merge_progress.h"
#include "tests/app/review/written_mission.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
/// What a review does with the map: its storeys, and tidying.
using ReviewMapTest = ReviewPage;

/// Rooms above each other: as many scans in each, floor and walls of all of them at one place.
MapPtr roomsAbove(const std::vector<double>& floors) {
    auto map = std::make_shared<Map>();
    for (const double floor : floors) {
        auto scan = std::make_shared<Scan>();
        for (int i = 0; i < 40; ++i) {
            for (int j = 0; j < 40; ++j) {
                const float x = 0.1F * static_cast<float>(i - 20), y = 0.1F * static_cast<float>(j - 20);
                scan->points.emplace_back(x, y, -0.9F);
                scan->labels.push_back(Label::Floor);
                scan->points.emplace_back(2.0F, y, x * 0.4F);
                scan->labels.push_back(Label::Wall);
            }
        }
        for (int i = 0; i < 8; ++i) {
            MapScan one;
            one.scan = scan;
            one.id = map->scans.size() + 1;
            one.poseInMap = poseFrom({0.3 * i, 0, floor + 0.9}, 0, 0, 0);
            map->scans.push_back(one);
        }
    }
    return map;
}

TEST_F(ReviewMapTest, OneStoreyOfTheMapIsShownByKeysOrItsButton) {
    ASSERT_TRUE(soon([&] { return m_bridge->index() != nullptr; }));
    QAction* const above = m_window->commands().find(QStringLiteral("map.storeyAbove"));
    auto& row = find<QWidget>("storeys");
    m_bridge->showInstead(roomsAbove({0.0}));
    ASSERT_TRUE(soon([&] { return !above->isEnabled() && !row.isVisible(); })) << "there is one only";
    m_bridge->showInstead(roomsAbove({0.0, 3.0, 6.0}));
    ASSERT_TRUE(soon([&] { return above->isEnabled() && row.isVisible(); }));
    const auto heights = [&] {
        const MapViewSettings& view = m_window->mapView().settings();
        return std::pair(view.minHeight.value_or(-99.0), view.maxHeight.value_or(99.0));
    };
    EXPECT_EQ(heights(), std::pair(-99.0, 99.0)) << "all are shown";
    find<QToolButton>("storey_1").click();
    lookAt("storeys");
    EXPECT_TRUE(heights().first > 1.5 && heights().first < 3.0) << heights().first;
    EXPECT_TRUE(heights().second > 4.5 && heights().second < 6.0) << heights().second;
    EXPECT_TRUE(find<QToolButton>("storey_1").isChecked());
    above->trigger();
    EXPECT_GT(heights().first, 4.5);
    EXPECT_EQ(heights().second, 99.0) << "nothing is above the highest one";
    EXPECT_NEAR(find<QDoubleSpinBox>("clipLow").value(), heights().first, 0.05);
    EXPECT_EQ(find<QDoubleSpinBox>("clipHigh").value(), 100.0) << "the bar says what is shown";
    above->trigger();
    EXPECT_EQ(heights(), std::pair(-99.0, 99.0)) << "beyond it are all";
    EXPECT_TRUE(find<QToolButton>("storey_all").isChecked());
    m_window->commands().trigger(QStringLiteral("map.storeyBelow"));
    EXPECT_TRUE(find<QToolButton>("storey_0").isChecked()) << "the lowest";
    EXPECT_NEAR(find<QDoubleSpinBox>("clipHigh").value(), heights().second, 0.05);
    m_bridge->showInstead(roomsAbove({0.0, 3.0, 6.0, 9.0, -3.0}));
    EXPECT_TRUE(soon([&] { return find<QToolButton>("storey_0").isChecked() && heights().first > -1.0; }))
        << "the same floor, whatever comes above and below it";
    find<QDoubleSpinBox>("clipHigh").setValue(1.0);
    EXPECT_FALSE(find<QToolButton>("storey_0").isChecked()) << "heights of the operator's own";
    EXPECT_FALSE(find<QToolButton>("storey_all").isChecked()) << "something is hidden";
    find<QToolButton>("storey_0").click();
    m_bridge->showInstead(roomsAbove({0.0}));
    EXPECT_TRUE(soon([&] { return heights() == std::pair(-99.0, 99.0); })) << "no storey is left to choose";
    m_bridge->showInstead(nullptr);
}

TEST_F(ReviewMapTest, TheMapIsTidiedOnRequestAndTakenBackOnlyWhereItWas) {
    std::vector<MapTidying> wanted;
    QObject::connect(m_window.get(), &ReviewWindow::tidyingWanted, m_window.get(),
                     [&](MapTidying what) { wanted.push_back(what); });
    ASSERT_TRUE(soon([&] { return m_bridge->index() != nullptr; }));
    QAction* const tidy = m_window->commands().find(QStringLiteral("review.tidy"));
    QAction* const back = m_window->commands().find(QStringLiteral("review.untidy"));
    EXPECT_TRUE(soon([&] { return tidy->isEnabled(); })) << "the mission has a map";
    EXPECT_FALSE(back->isEnabled()) << "its map was not tidied";
    m_bridge->reportInto(QString::fromStdString((m_folder / "report").string()));
    tidy->trigger();
    EXPECT_TRUE(wanted.empty()) << "the report that was asked for is not lost";
    ASSERT_TRUE(soon([&] { return !m_bridge->reporting(); }));
    tidy->trigger();
    EXPECT_EQ(wanted, std::vector{MapTidying::Tidy});
}

TEST_F(ReviewMapTest, ItsMapIsMergedWithThatOfAnotherMissionThatHasOne) {
    std::vector<QString> wanted;
    QObject::connect(m_window.get(), &ReviewWindow::mergingWanted, m_window.get(),
                     [&](const QString& folder) { wanted.push_back(folder); });
    QAction* const merge = m_window->commands().find(QStringLiteral("review.mergeMaps"));
    ASSERT_TRUE(soon([&] { return merge->isEnabled(); })) << "the mission has a map";
    const auto choose = [&](const std::filesystem::path& folder) {
        merge->trigger();
        auto& choice = find<QFileDialog>("mergeWith");
        emit choice.fileSelected(QString::fromStdString(folder.string()));
        choice.close();
        ASSERT_TRUE(soon([&] { return m_window->findChild<QFileDialog*>() == nullptr; }));
    };
    choose(m_mission);
    EXPECT_THAT(m_window->newest().toStdString(), HasSubstr("this mission"));
    WrittenMission(m_folder / "empty").sayOdometry(1.0, 0.0);
    choose(m_folder / "empty");
    EXPECT_THAT(m_window->newest().toStdString(), HasSubstr("empty: expected a map"));
    EXPECT_TRUE(wanted.empty());
    WrittenMission(m_folder / "other").sayKeyScan(1.0, 1, 0.0);
    choose(m_folder / "other");
    EXPECT_EQ(wanted, std::vector{QString::fromStdString((m_folder / "other").string())});
}

TEST_F(ReviewMapTest, AMergedMissionLiesBesideTheFirstAndTellsWhereItIsNotSure) {
    m_window.reset();
    m_bridge.reset();
    WrittenMission(m_folder / "other").sayKeyScan(1.0, 1, 0.0);
    const MergingOutcome outcome = mergeInFront(m_mission, m_folder / "other");
    EXPECT_EQ(outcome.mission, m_folder / "mission+other");
    EXPECT_THAT(outcome.text.toStdString(), HasSubstr("lie side by side"));
    EXPECT_TRUE(ReviewBridge::open(outcome.mission));
    EXPECT_EQ(mergedName(m_mission, m_folder / "other"), m_folder / "mission+other-2");
    const MergingOutcome none = mergeInFront(m_mission, m_folder / "absent");
    EXPECT_TRUE(none.mission.empty());
    EXPECT_THAT(none.text.toStdString(), HasSubstr("absent"));
}

TEST_F(ReviewMapTest, TidyingIsDoneInFrontOfAWindowThatCancelsIt) {
    m_window.reset();
    m_bridge.reset();
    EXPECT_THAT(tidyInFront(m_mission, MapTidying::TakeBack).text.toStdString(), HasSubstr("was not tidied"));
    bool pressed = false;
    QTimer cancel;
    QObject::connect(&cancel, &QTimer::timeout, &cancel, [&] {
        for (QWidget* const top : QApplication::topLevelWidgets()) {
            auto* const button = top->isVisible() ? top->findChild<QPushButton*>() : nullptr;
            if (qobject_cast<QProgressDialog*>(top) == nullptr || button == nullptr || pressed) continue;
            pressed = true;
            button->click();
            EXPECT_TRUE(top->isVisible()) << "until the work has ended";
        }
    });
    cancel.start(0);
    const TidyingOutcome outcome = tidyInFront(m_mission, MapTidying::Tidy);
    cancel.stop();
    EXPECT_TRUE(pressed);
    EXPECT_FALSE(outcome.moved);
    EXPECT_THAT(outcome.text.toStdString(), HasSubstr("the map is as it was"));
    EXPECT_TRUE(ReviewBridge::open(m_mission)) << "the mission is as it was";
}

}  // namespace
}  // namespace leitstand::test
