#include "widgets/models/review/comparison_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QLocale>

#include "widgets/models/review/compared_text.h"
#include "widgets/models/review/text_table_model.h"

namespace leitstand {
namespace {

MapComparison comparison() {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    MapComparison whole;
    for (int i = 0; i < 3; ++i) {
        ComparedScan one;
        one.id = static_cast<std::uint64_t>(i + 1);
        one.robot = "kurt3d";
        one.again = poseFrom({0.01 * i, 0, 0}, 0, 0, degrees(0.5 * i));
        if (i > 0) one.fitRecorded = one.fitAgain = ScanFit{0.012, 0.8};
        one.uncertainRecorded = i == 1;
        one.uncertainAgain = i == 2;
        whole.scans.push_back(one);
    }
    whole.rejected = 2;
    whole.recorded = {.uncertain = 1, .rms = 0.0123, .overlap = 0.83, .path = 4.5};
    whole.again = {.uncertain = 0, .rms = 0.0098, .overlap = 0.9, .path = 4.4, .seconds = 1.25};
    whole.meanMoved = 0.01;
    whole.mostMoved = 0.02;
    whole.meanTurned = degrees(0.5);
    whole.mostTurned = degrees(1.0);
    return whole;
}

QStringList rowOf(const TextTable& table, const char* name) {
    for (const TextTable::Row& row : table.rows) {
        if (row.cells.front() == QLatin1String(name)) return row.cells;
    }
    return {};
}

TEST(ComparisonRows, BothMapsStandSideBySide) {
    const TextTable table = figuresOf(comparison());
    EXPECT_EQ(table.header, QStringList({"Figure", "As recorded", "Registered again"}));
    EXPECT_EQ(rowOf(table, "Residual"), QStringList({"Residual", "12.3 mm", "9.8 mm"}));
    EXPECT_EQ(rowOf(table, "Uncertain"), QStringList({"Uncertain", "1", "0"}));
    EXPECT_EQ(rowOf(table, "Set aside"), QStringList({"Set aside", "2", "–"}));
    EXPECT_EQ(rowOf(table, "Moved"), QStringList({"Moved", "–", "10.0 mm, at most 20.0 mm"}));
    EXPECT_EQ(rowOf(table, "Path"), QStringList({"Path", "4.50 m", "4.40 m"}));
    EXPECT_TRUE(rowOf(table, "Off the truth").isEmpty()) << "nobody knows it";
    for (const TextTable::Row& row : table.rows) {
        EXPECT_EQ(row.cells.size(), table.header.size());
        EXPECT_FALSE(row.hint.isEmpty()) << row.cells.front().toStdString();
    }
}

TEST(ComparisonRows, TheMapsTitleSaysWhichMapIsShown) {
    const MapSummary again = comparedSummaryOf(comparison(), ComparedMap::Again);
    EXPECT_EQ(again.title.toStdString(), "3D map · registered again · 3 key scans");
    EXPECT_EQ(again.result.toStdString(), "moved 20.0 mm at most");
    EXPECT_FALSE(again.hint.isEmpty());
    EXPECT_NE(comparedSummaryOf(comparison(), ComparedMap::Both).title, again.title);
}

TEST(ComparisonRows, ErrorsAgainstTheTruthStandWhereItIsKnown) {
    MapComparison whole = comparison();
    whole.recorded.truth = TrajectoryError{.poses = 3, .position = 0.031, .rotation = degrees(0.4)};
    whole.again.truth = TrajectoryError{.poses = 3, .position = 0.042, .rotation = degrees(0.6)};
    whole.recorded.finds = FindsError{.finds = 3, .mean = 0.1, .worst = 0.15, .missed = 4, .wrong = 1};
    whole.again.finds = FindsError{.finds = 1, .missed = 6, .wrong = 1};
    const TextTable table = figuresOf(whole);
    EXPECT_EQ(rowOf(table, "Off the truth"), QStringList({"Off the truth", "31.0 mm", "42.0 mm"}));
    EXPECT_EQ(rowOf(table, "Turned off the truth").size(), 3);
    EXPECT_EQ(rowOf(table, "Victims found"),
              QStringList({"Victims found", "2, missed 4, false 1", "0, missed 6, false 1"}));
    EXPECT_EQ(rowOf(table, "Victims off the truth"),
              QStringList({"Victims off the truth", "100.0 mm, at most 150.0 mm", "–"}));
}

TEST(ComparisonRows, EveryScanHasItsRow) {
    const TextTable table = scansOf(comparison());
    ASSERT_EQ(table.rows.size(), 3U);
    EXPECT_EQ(table.rows[0].cells.value(0), QStringLiteral("kurt3d 1"));
    EXPECT_EQ(table.rows[0].cells.value(1), QStringLiteral("–"));
    EXPECT_EQ(table.rows[1].cells.value(5), QStringLiteral("10.0 mm"));
    EXPECT_EQ(table.rows[1].cells.value(7), QStringLiteral("was uncertain"));
    EXPECT_EQ(table.rows[2].cells.value(7), QStringLiteral("uncertain again"));
}

TEST(ComparisonRows, TheTableSaysWhatItsRowsMean) {
    TextTableModel model;
    EXPECT_EQ(model.rowCount(), 0);
    model.setTable(figuresOf(comparison()));
    EXPECT_EQ(model.columnCount(), 3);
    EXPECT_EQ(model.data(model.index(0, 1)).toString(), QStringLiteral("3"));
    EXPECT_FALSE(model.data(model.index(0, 1), Qt::ToolTipRole).toString().isEmpty());
    EXPECT_EQ(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("As recorded"));
}

}  // namespace
}  // namespace leitstand
