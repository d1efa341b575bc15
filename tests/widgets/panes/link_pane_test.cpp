#include "widgets/link/link_pane.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QAction>
#include <QCheckBox>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include "core/event/stream_role.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/painting/number_box.h"

namespace leitstand::test {
namespace {

StreamRow row(const std::string& sensor, StreamRole role, double rate, double megabits) {
    StreamRow row;
    row.face = {"kurt3d", "K", "Kurt3D", 0};
    row.type = role == StreamRole::Points ? "PointCloud2" : "CompressedImage";
    row.settable = true;
    row.stream.role = role;
    row.stream.sensor = sensor;
    row.stream.topic = "/kurt3d/" + sensor;
    row.stream.samples = 1000;
    row.stream.rate = row.stream.expectedRate = rate;
    row.stream.megabitsPerSecond = megabits;
    row.stream.age = 0.05;
    row.stream.steady = true;
    return row;
}

std::vector<StreamRow> rows() {
    std::vector<StreamRow> all = {
        row("scanner", StreamRole::Points, 10, 1.1), row("left", StreamRole::Picture, 15, 0.6),
        row("right", StreamRole::Picture, 15, 0.6), row("ir", StreamRole::Thermal, 9, 0.9),
        row("odom", StreamRole::Odometry, 50, 0.1)};
    all[2].effective = {true, 1.0, 20, 320};
    all[2].stream.rate = all[2].stream.expectedRate = 1.0;
    all[3].stream.paused = true;
    all[3].effective.enabled = false;
    all[4].settable = false;
    return all;
}

class LinkPanes : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override { useTheme(GetParam()); }

    QAction thin{QStringLiteral("Thin link")};
};

TEST_P(LinkPanes, OfSeveralCloudsOneMakesTheMapAndAnotherIsChosenByAClick) {
    LinkPane pane(thin);
    pane.resize(620, 300);
    auto all = rows();
    all.insert(all.begin() + 1, row("depth", StreamRole::Points, 15, 3.0));
    all[0].mayMap = all[1].mayMap = true;
    all[0].maps = true;
    pane.show(all, 2.4, true, 2.0);
    (void)pictureOf(pane, {620, 300}, GetParam() == Theme::Dark ? "link_map_dark" : "link_map_light", 2.0);
    auto* table = pane.findChild<QTableView*>("streams");
    auto* maps = pane.findChild<QCheckBox*>("maps");
    QSignalSpy chosen(&pane, &LinkPane::mapChosen);
    EXPECT_EQ(streamNameText(*pane.table().row(0)), "K  3D scans scanner (map)");
    table->selectRow(0);
    EXPECT_TRUE(maps->isVisibleTo(&pane) && maps->isChecked() && !maps->isEnabled()) << "it cannot be none";
    table->selectRow(1);
    ASSERT_TRUE(maps->isVisibleTo(&pane) && !maps->isChecked() && maps->isEnabled());
    maps->click();
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen[0][0].toString(), "kurt3d");
    EXPECT_EQ(chosen[0][1].toString(), "/kurt3d/depth");
    std::swap(all[0].maps, all[1].maps);
    pane.show(all, 2.4, true, 2.0);
    EXPECT_TRUE(maps->isChecked() && !maps->isEnabled());
    table->selectRow(2);
    EXPECT_FALSE(maps->isVisibleTo(&pane)) << "pictures make no map";
    EXPECT_EQ(chosen.count(), 1);
}

TEST_P(LinkPanes, ShowsStreamsAndEditsTheChosenOne) {
    thin.setCheckable(true);
    LinkPane pane(thin);
    pane.resize(620, 300);
    pane.show(rows(), 2.4, true, 2.0);
    auto* table = pane.findChild<QTableView*>("streams");
    QSignalSpy requested(&pane, &LinkPane::requested), budget(&pane, &LinkPane::budgetChosen);
    table->selectRow(1);
    auto* rate = pane.findChild<NumberBox*>("rate");
    ASSERT_TRUE(rate->isEnabled());
    EXPECT_EQ(requested.count(), 0) << "choosing a row wishes nothing";
    rate->setValue(5.0);
    ASSERT_EQ(requested.count(), 1);
    EXPECT_EQ(requested[0][1].toString(), "/kurt3d/left");
    EXPECT_EQ(requested[0][2].value<StreamRequest>().rate, 5.0);
    pane.findChild<QCheckBox*>("enabled")->setChecked(false);
    EXPECT_FALSE(requested.back()[2].value<StreamRequest>().enabled);
    (void)pictureOf(pane, {620, 300}, GetParam() == Theme::Dark ? "link_dark" : "link_light", 2.0);
    table->selectRow(0);
    EXPECT_FALSE(pane.findChild<NumberBox*>("quality")->isEnabled()) << "scans have no quality";
    table->selectRow(4);
    EXPECT_FALSE(rate->isEnabled());
    pane.findChild<NumberBox*>("budget")->setValue(3.0);
    EXPECT_EQ(budget.back()[0].toDouble(), 3.0);
    EXPECT_EQ(requested.count(), 2);
}

INSTANTIATE_TEST_SUITE_P(Themes, LinkPanes, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& one) { return one.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
