#include "widgets/models/map/key_scan_model.h"

#include <QSignalSpy>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/scan_pose.h"
#include "widgets/models/map/doubt_text.h"
#include "widgets/models/tone.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using Column = KeyScanModel::Column;

LiveKeyScan keyScan(std::uint64_t id, ScanTrust trust = ScanTrust::Certain, std::uint8_t doubts = 0) {
    auto scan = std::make_shared<Scan>();
    scan->robot = id % 2 == 1 ? "kurt3d" : "crawler";
    LiveKeyScan key;
    key.id = id;
    key.scan = std::move(scan);
    key.pose.scan = id;
    key.pose.trust = trust;
    key.pose.doubts = doubts;
    key.pose.overlap = 0.834;
    key.matched = id - 1;
    return key;
}

LiveMapPtr mapOf(std::vector<LiveKeyScan> scans) {
    auto map = std::make_shared<LiveMap>();
    map->scans = std::move(scans);
    return map;
}

constexpr auto Jump = static_cast<std::uint8_t>(ScanDoubt::Jump);
constexpr auto Overlap = static_cast<std::uint8_t>(ScanDoubt::Overlap);

class KeyScans : public testing::Test {
protected:
    KeyScans() {
        model.setRobots({{QStringLiteral("kurt3d"), QStringLiteral("K"), QStringLiteral("Kurt3D"), 0},
                         {QStringLiteral("crawler"), QStringLiteral("C"), QStringLiteral("Crawler"), 1}});
        model.setScans(mapOf({keyScan(1), keyScan(2), keyScan(3, ScanTrust::Uncertain, Jump | Overlap)}));
    }
    [[nodiscard]] std::string text(int row, Column column) const {
        return model.index(row, column).data().toString().toStdString();
    }
    [[nodiscard]] Tone tone(int row, Column column) const {
        return static_cast<Tone>(model.index(row, column).data(ToneRole).toInt());
    }
    KeyScanModel model;
};

TEST_F(KeyScans, StandNewestFirstWithTheirRobot) {
    EXPECT_EQ(model.rowCount(), 3);
    EXPECT_EQ(text(0, Column::Name), "K 3");
    EXPECT_EQ(text(1, Column::Name), "C 2");
    EXPECT_EQ(model.index(1, Column::Overlap).data().toString(), QStringLiteral("83\u202F%"));
    EXPECT_EQ(text(2, Column::Overlap), "–") << "the first was matched with nothing";
}

TEST_F(KeyScans, SayWhatSpeaksAgainstThem) {
    EXPECT_EQ(text(0, Column::Trust), "uncertain ?");
    EXPECT_EQ(text(0, Column::Doubts), "little overlap, jump");
    EXPECT_EQ(tone(0, Column::Trust), Tone::Attention);
    EXPECT_EQ(tone(0, Column::Name), Tone::Normal);
    EXPECT_EQ(text(1, Column::Trust), "certain");
    EXPECT_EQ(text(1, Column::Doubts), "");
    EXPECT_EQ(tone(1, Column::Trust), Tone::Normal);
    EXPECT_THAT(keyScanDetails(model.scans().scans[2]).toStdString(), HasSubstr("otherwise than the wheels"));
}

TEST_F(KeyScans, SayThatTheirMotionIsGuessedWithoutBeingDoubted) {
    constexpr auto Guessed = static_cast<std::uint8_t>(ScanDoubt::Guessed);
    model.setScans(
        mapOf({keyScan(1, ScanTrust::Certain, Guessed), keyScan(2, ScanTrust::Uncertain, Jump | Guessed)}));
    EXPECT_EQ(text(1, Column::Doubts), "motion partly guessed");
    EXPECT_EQ(text(1, Column::Trust), "certain");
    EXPECT_EQ(tone(1, Column::Doubts), Tone::Muted);
    const std::string certain = keyScanDetails(model.scans().scans[0]).toStdString();
    EXPECT_THAT(certain, HasSubstr("It fits."));
    EXPECT_THAT(certain, HasSubstr("missing or late"));
    EXPECT_EQ(text(0, Column::Doubts), "jump, motion partly guessed");
    const std::string doubted = keyScanDetails(model.scans().scans[1]).toStdString();
    EXPECT_THAT(doubted, HasSubstr("otherwise than the wheels"));
    EXPECT_THAT(doubted, HasSubstr("missing or late"));
}

TEST_F(KeyScans, TellWhichWaitsForADecision) {
    EXPECT_EQ(model.newestUncertain(), 3U);
    EXPECT_EQ(model.uncertain(), 1);
    EXPECT_THAT(keyScanSummary(model).toStdString(), HasSubstr("1 for you to decide"));
    model.setScans(mapOf({keyScan(1), keyScan(2), keyScan(3, ScanTrust::SetAside, Jump)}));
    EXPECT_EQ(model.newestUncertain(), 0U);
    EXPECT_EQ(tone(0, Column::Name), Tone::Muted);
    EXPECT_EQ(text(0, Column::Trust), "set aside");
}

TEST_F(KeyScans, ThatWaitAreVisitedOneAfterTheOther) {
    model.setScans(
        mapOf({keyScan(1, ScanTrust::Uncertain, Jump), keyScan(2), keyScan(3, ScanTrust::Uncertain, Jump)}));
    EXPECT_EQ(model.uncertainBefore(0), 3U);
    EXPECT_EQ(model.uncertainBefore(2), 3U);
    EXPECT_EQ(model.uncertainBefore(3), 1U);
    EXPECT_EQ(model.uncertainBefore(1), 3U);
}

TEST_F(KeyScans, WhatWasDoubtedAndAcceptedIsCalm) {
    model.setScans(mapOf({keyScan(1), keyScan(2), keyScan(3, ScanTrust::Certain, Jump)}));
    EXPECT_EQ(tone(0, Column::Doubts), Tone::Muted);
    EXPECT_THAT(keyScanDetails(model.scans().scans[2]).toStdString(), HasSubstr("Accepted by the operator"));
}

TEST_F(KeyScans, ThatComeLeaveTheOthersChosen) {
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    const QPersistentModelIndex chosen = model.index(0, 0);
    model.setScans(mapOf({keyScan(1), keyScan(2), keyScan(3), keyScan(4), keyScan(5)}));
    EXPECT_EQ(inserted.count(), 1);
    EXPECT_EQ(reset.count(), 0);
    EXPECT_EQ(chosen.row(), 2);
    EXPECT_EQ(model.rowOf(3), 2);
    model.setScans(mapOf({keyScan(7)}));  // another mission
    EXPECT_EQ(reset.count(), 1);
    EXPECT_EQ(model.rowOf(3), -1);
}

TEST(Doubts, EachHasWordsOfItsOwn) {
    QStringList words;
    for (int bit = 0; bit < 7; ++bit) {
        const auto doubt = static_cast<std::uint8_t>(1 << bit);
        EXPECT_FALSE(doubtText(doubt).isEmpty());
        EXPECT_FALSE(doubtDetails(doubt).isEmpty());
        EXPECT_FALSE(words.contains(doubtText(doubt)));
        words += doubtText(doubt);
    }
    EXPECT_EQ(doubtText(0), "");
}

}  // namespace
}  // namespace leitstand::test
