#include "widgets/models/scan_list_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QAbstractItemModelTester>
#include <QLocale>
#include <QSignalSpy>

#include "tests/widgets/models/sample_map.h"
#include "widgets/models/scan_texts.h"
#include "widgets/models/tone.h"

namespace leitstand {
namespace {

using test::sampleMap;
using testing::ElementsAre;
using testing::IsEmpty;

class ScanListModelTest : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    [[nodiscard]] std::string text(int row, ScanListModel::Column column) const {
        return m_model.index(row, column).data().toString().toStdString();
    }
    [[nodiscard]] Tone tone(int row, ScanListModel::Column column) const {
        return static_cast<Tone>(m_model.index(row, column).data(ToneRole).toInt());
    }

    ScanListModel m_model;
    QAbstractItemModelTester m_tester{&m_model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(ScanListModelTest, ARowTellsTheFiguresOfAScan) {
    m_model.setMap(sampleMap(2));
    EXPECT_EQ(text(1, ScanListModel::Name), "scan001");
    EXPECT_EQ(text(1, ScanListModel::Position), "1.57  0.04  −0.09");
    EXPECT_EQ(text(1, ScanListModel::Heading), "−0.7°");
    EXPECT_EQ(text(1, ScanListModel::Points), "81,360");
    EXPECT_EQ(text(1, ScanListModel::Floor), "25\u202f%");
    EXPECT_EQ(text(1, ScanListModel::Wall), "63\u202f%");
    EXPECT_EQ(text(1, ScanListModel::Ceiling), "13\u202f%");
    EXPECT_EQ(text(1, ScanListModel::Iterations), "12");
    EXPECT_EQ(text(1, ScanListModel::Rms), "12.3");
    EXPECT_EQ(text(1, ScanListModel::Overlap), "83\u202f%");
    EXPECT_EQ(text(1, ScanListModel::Certainty), "certain");
}

TEST_F(ScanListModelTest, TheFirstScanIsTheReferenceAndHasNoFigures) {
    m_model.setMap(sampleMap(2));
    EXPECT_EQ(text(0, ScanListModel::Certainty), "reference");
    for (const auto column : {ScanListModel::Iterations, ScanListModel::Rms, ScanListModel::Overlap}) {
        EXPECT_EQ(text(0, column), "–");
        EXPECT_EQ(tone(0, column), Tone::Muted);
    }
}

TEST_F(ScanListModelTest, ScansNotToBeTrustedAreMarkedByTextAndTone) {
    const auto map = sampleMap(3);
    map->scans[1].icp.converged = false;
    map->scans[1].icp.stop = IcpStop::IterationLimit;
    map->scans[2].icp.certainty = 0.01;
    m_model.setMap(map);
    EXPECT_EQ(text(1, ScanListModel::Certainty), "▲ not converged");
    EXPECT_EQ(text(2, ScanListModel::Certainty), "▲ uncertain");
    EXPECT_EQ(tone(1, ScanListModel::Certainty), Tone::Attention);
    EXPECT_EQ(tone(2, ScanListModel::Certainty), Tone::Attention);
    EXPECT_THAT(m_model.index(1, ScanListModel::Certainty).data(Qt::ToolTipRole).toString().toStdString(),
                testing::HasSubstr("limit of iterations"));
}

TEST_F(ScanListModelTest, TickBoxesSayWhichScansAreShown) {
    m_model.setMap(sampleMap(3));
    EXPECT_THAT(m_model.visible(), ElementsAre(true, true, true));
    QSignalSpy changed(&m_model, &ScanListModel::visibilityChanged);
    const QModelIndex second = m_model.index(1, ScanListModel::Name);
    EXPECT_TRUE(m_model.flags(second) & Qt::ItemIsUserCheckable);
    EXPECT_TRUE(m_model.setData(second, Qt::Unchecked, Qt::CheckStateRole));
    EXPECT_THAT(m_model.visible(), ElementsAre(true, false, true));
    EXPECT_EQ(second.data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
    EXPECT_EQ(changed.size(), 1);
    m_model.setAllVisible(true);
    EXPECT_THAT(m_model.visible(), ElementsAre(true, true, true));
}

TEST_F(ScanListModelTest, TicksStayWithTheirRowsWhileTheMapGrows) {
    m_model.setMap(sampleMap(2));
    m_model.setData(m_model.index(0, ScanListModel::Name), Qt::Unchecked, Qt::CheckStateRole);
    m_model.setMap(sampleMap(4));
    EXPECT_THAT(m_model.visible(), ElementsAre(false, true, true, true));
    m_model.setMap(sampleMap(0));
    EXPECT_THAT(m_model.visible(), IsEmpty());
    m_model.setMap(sampleMap(1));
    EXPECT_THAT(m_model.visible(), ElementsAre(true));
}

TEST_F(ScanListModelTest, OnlyNewRowsAreInserted) {
    m_model.setMap(sampleMap(2));
    QSignalSpy inserted(&m_model, &QAbstractItemModel::rowsInserted);
    QSignalSpy reset(&m_model, &QAbstractItemModel::modelReset);
    m_model.setMap(sampleMap(3));
    ASSERT_EQ(inserted.size(), 1);
    EXPECT_EQ(inserted[0][1].toInt(), 2);
    EXPECT_TRUE(reset.isEmpty());
}

TEST_F(ScanListModelTest, EveryColumnHasATitleAndSaysWhatItTells) {
    for (int column = 0; column < ScanListModel::ColumnCount; ++column) {
        EXPECT_FALSE(m_model.headerData(column, Qt::Horizontal).toString().isEmpty()) << column;
        EXPECT_FALSE(m_model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty())
            << column;
    }
}

TEST_F(ScanListModelTest, DetailsTellHowFarAScanWasCorrected) {
    const auto details = scanDetails(sampleMap(2)->scans[1]);
    const auto corrected = std::find_if(details.begin(), details.end(), [](const ScanDetail& detail) {
        return detail.first == QStringLiteral("Corrected by");
    });
    ASSERT_NE(corrected, details.end());
    EXPECT_EQ(corrected->second.toStdString(), "0.121 m, 0.7°");
}

}  // namespace
}  // namespace leitstand
