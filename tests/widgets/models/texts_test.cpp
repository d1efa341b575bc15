#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QLocale>
#include <QSignalSpy>

#include "tests/widgets/models/sample_map.h"
#include "widgets/models/map_text.h"
#include "widgets/models/message_list_model.h"
#include "widgets/models/numbers.h"
#include "widgets/models/registration_choices.h"
#include "widgets/models/tone.h"

namespace leitstand {
namespace {

using test::sampleMap;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Optional;

class TextsTest : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
};

TEST_F(TextsTest, NegativeNumbersHaveARealMinusAndNothingHasNone) {
    EXPECT_EQ(numberText(-2.0, 2).toStdString(), "−2.00");
    EXPECT_EQ(numberText(-0.004, 2).toStdString(), "0.00");
    EXPECT_EQ(degreesText(degrees(-12.34)).toStdString(), "−12.3°");
}

TEST_F(TextsTest, NumbersFollowTheLanguage) {
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(numberText(1.5, 1).toStdString(), "1,5");
    EXPECT_EQ(countText(81'360).toStdString(), "81.360");
}

TEST_F(TextsTest, FiguresHaveNoMoreDigitsThanTheyNeed) {
    EXPECT_EQ(figureText(10.0, 2).toStdString(), "10");
    EXPECT_EQ(figureText(2.5, 2).toStdString(), "2.5");
    EXPECT_EQ(figureText(-0.25, 2).toStdString(), "−0.25");
    EXPECT_EQ(figureText(4.97, 1).toStdString(), "5") << "as it is rounded";
    EXPECT_EQ(figureText(-0.004, 2).toStdString(), "0");
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(figureText(2.5, 2).toStdString(), "2,5");
}

TEST_F(TextsTest, LargeCountsAreShort) {
    EXPECT_EQ(shortCountText(812).toStdString(), "812");
    EXPECT_EQ(shortCountText(7'640).toStdString(), "7.6\u202fk");
    EXPECT_EQ(shortCountText(244'080).toStdString(), "0.24\u202fM");
}

TEST_F(TextsTest, AMapIsSummedUpByItsWorstScan) {
    const auto map = sampleMap(3);
    map->scans[2].icp.overlap = 0.56;
    const MapSummary good = summaryOf(*map);
    EXPECT_EQ(good.title.toStdString(), "3D map · 3 scans · 0.24\u202fM points");
    EXPECT_EQ(good.result.toStdString(), "registered in 0.6 s · overlap 56\u202f% · certain");
    EXPECT_EQ(good.tone, Tone::Normal);
    map->scans[1].icp.certainty = 0.001;
    const MapSummary bad = summaryOf(*map);
    EXPECT_THAT(bad.result.toStdString(), HasSubstr("scan001 uncertain"));
    EXPECT_EQ(bad.tone, Tone::Attention);
}

TEST_F(TextsTest, AMapOfOneScanHasNoResultYet) {
    EXPECT_EQ(summaryOf(*sampleMap(1)).title.toStdString(), "3D map · 1 scan · 81.4\u202fk points");
    EXPECT_TRUE(summaryOf(*sampleMap(1)).result.isEmpty());
    EXPECT_EQ(summaryOf(Map{}).title.toStdString(), "3D map");
}

TEST_F(TextsTest, SchedulesAreReadAsTheyAreWritten) {
    EXPECT_THAT(parseSchedule(QStringLiteral("1.5, 0.5")), Optional(ElementsAre(1.5, 0.5)));
    EXPECT_THAT(parseSchedule(QStringLiteral(" 0.5 ")), Optional(ElementsAre(0.5)));
    EXPECT_THAT(parseSchedule(QStringLiteral("2;1 0.25")), Optional(ElementsAre(2.0, 1.0, 0.25)));
    EXPECT_EQ(scheduleText({1.5, 0.5}).toStdString(), "1.5, 0.5");
}

TEST_F(TextsTest, SchedulesThatMakeNoSenseAreRefused) {
    for (const char* wrong : {"", " , ", "abc", "0", "-1", "0.5, 1.5", "11", "nan", "1.5, x"}) {
        EXPECT_FALSE(parseSchedule(QLatin1String(wrong)).has_value()) << wrong;
    }
}

TEST_F(TextsTest, EveryMethodOfThePaperIsOnOfferWithItsSource) {
    EXPECT_EQ(searchChoices().size(), 4u);
    EXPECT_EQ(minimizerChoices().size(), 6u);
    for (const auto& choice : minimizerChoices()) {
        EXPECT_THAT(choice.hint.toStdString(), testing::ContainsRegex("[A-Z][a-z]+ [0-9]{4}\\)"));
        EXPECT_THAT(valueOf(minimizerChoices(), keyOf(minimizerChoices(), choice.value)), choice.value);
    }
    EXPECT_FALSE(valueOf(searchChoices(), QStringLiteral("octree")).has_value());
}

TEST_F(TextsTest, MessagesAreCountedDismissedAndNotRepeated) {
    MessageListModel messages;
    messages.add(MessageListModel::Severity::Error, QStringLiteral("a.3d:1: broken"));
    messages.add(MessageListModel::Severity::Error, QStringLiteral("a.3d:1: broken"));
    messages.add(MessageListModel::Severity::Warning, QStringLiteral("a.pose: missing"));
    ASSERT_EQ(messages.rowCount(), 2);
    EXPECT_EQ(messages.errorCount(), 1);
    EXPECT_THAT(messages.index(0).data().toString().toStdString(), HasSubstr("Error"));
    EXPECT_EQ(messages.index(0).data(ToneRole).toInt(), static_cast<int>(Tone::Attention));
    messages.dismiss(0);
    EXPECT_EQ(messages.errorCount(), 0);
    messages.dismiss(7);
    EXPECT_EQ(messages.rowCount(), 1);
    messages.clear();
    EXPECT_EQ(messages.rowCount(), 0);
}

TEST_F(TextsTest, AMessageToldAgainIsTheNewest) {
    MessageListModel messages;
    for (const char* text : {"snapshot kept", "link lost", "snapshot kept"})
        messages.addReported(QString::fromLatin1(text));
    ASSERT_EQ(messages.rowCount(), 2);
    EXPECT_EQ(messages.index(0).data(Qt::ToolTipRole).toString().toStdString(), "link lost");
    EXPECT_EQ(messages.index(1).data(Qt::ToolTipRole).toString().toStdString(), "snapshot kept");
    EXPECT_EQ(messages.errorCount(), 0);
}

TEST_F(TextsTest, AMessageOfSeveralLinesIsOneAndTurnsNothing) {
    MessageListModel messages;
    messages.addReported(QString::fromUtf8("a.yaml:3: no rate\na.yaml:7: \u202eno topic\n"));
    EXPECT_EQ(messages.index(0).data(Qt::ToolTipRole).toString().toStdString(),
              "a.yaml:3: no rate · a.yaml:7: \\u202eno topic");
}

TEST_F(TextsTest, AFloodOfMessagesKeepsTheNewest) {
    MessageListModel messages;
    for (int i = 0; i < 600; ++i) messages.add(MessageListModel::Severity::Error, QString::number(i));
    EXPECT_EQ(messages.rowCount(), 500);
    EXPECT_EQ(messages.index(499).data(Qt::ToolTipRole).toString().toStdString(), "599");
}

}  // namespace
}  // namespace leitstand
