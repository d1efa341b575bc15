#include "core/station/alarms/alarm_book.h"

#include <gtest/gtest.h>

#include "core/event/scan_links.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

using Kind = AlarmChange::Kind;
const AlarmId Link{"kurt3d", "link_lost", ""}, Battery{"kurt3d", "battery", ""};

AlarmCause act(const AlarmId& id = Link) {
    return {id, AlarmSeverity::Act};
}
AlarmCause look(const AlarmId& id = Battery) {
    return {id, AlarmSeverity::Attention};
}

/// A book that is told five times a second.
class AlarmBookTest : public testing::Test {
protected:
    /// Tells @p causes until @p end [ms]; what changed.
    std::vector<Kind> until(std::int64_t end, const std::vector<AlarmCause>& causes) {
        std::vector<Kind> kinds;
        for (; m_now < end; m_now += 200) {
            for (const AlarmChange& change : m_book.update(causes, wallAt(m_now)))
                kinds.push_back(change.kind);
        }
        return kinds;
    }
    AlarmBook m_book;
    std::int64_t m_now = 0;
};

TEST_F(AlarmBookTest, IsRaisedOnceAndEndsOnceWhateverFlaps) {
    EXPECT_TRUE(until(200, {act()}).empty()) << "too short";
    EXPECT_TRUE(until(400, {}).empty());
    EXPECT_EQ(until(2'000, {act()}), std::vector{Kind::Raised});
    for (int i = 0; i < 10; ++i) {
        EXPECT_TRUE(until(m_now + 1'800, {}).empty()) << "not gone for long enough";
        EXPECT_TRUE(until(m_now + 200, {act()}).empty());
    }
    EXPECT_TRUE(m_book.stands(Link));
    EXPECT_EQ(until(m_now + 4'000, {}), std::vector{Kind::Ended});
    EXPECT_FALSE(m_book.stands(Link));
    ASSERT_EQ(m_book.alarms().size(), 1u);
    EXPECT_TRUE(m_book.alarms()[0].ended);
    EXPECT_FALSE(m_book.alarms()[0].isLoud()) << "what is over needs no tone";
}

TEST_F(AlarmBookTest, ACauseThatMustLastForSecondsIsRaisedThen) {
    AlarmCause slow = act();
    slow.persists = std::chrono::seconds(5);
    EXPECT_TRUE(until(5'000, {slow}).empty());
    EXPECT_EQ(until(5'400, {slow}), std::vector{Kind::Raised});
    EXPECT_EQ(until(m_now + 4'000, {}), std::vector{Kind::Ended});
    EXPECT_TRUE(until(m_now + 4'800, {slow}).empty()) << "it begins again";
    EXPECT_TRUE(until(m_now + 400, {}).empty());
    EXPECT_TRUE(until(m_now + 4'800, {slow}).empty());
}

TEST_F(AlarmBookTest, ACauseThatGetsLouderForSecondsIsRaisedAgainThen) {
    AlarmCause quiet = look(Link), loud = act(Link);
    loud.persists = std::chrono::seconds(5);
    EXPECT_EQ(until(1'000, {quiet}), std::vector{Kind::Raised});
    EXPECT_TRUE(until(m_now + 4'800, {loud}).empty());
    EXPECT_EQ(m_book.severity(Link), AlarmSeverity::Attention);
    EXPECT_EQ(until(m_now + 1'000, {loud}), std::vector{Kind::Raised});
    EXPECT_EQ(m_book.severity(Link), AlarmSeverity::Act);
}

TEST_F(AlarmBookTest, WhatSaidActStaysUntilItIsAcknowledgedOthersGo) {
    until(1'000, {act(), look()});
    EXPECT_EQ(m_book.attentions(), 1u);
    until(60'000, {});
    ASSERT_EQ(m_book.alarms().size(), 1u);
    EXPECT_EQ(m_book.alarms()[0].cause.id, Link);
    const auto changes = m_book.acknowledge(Link, wallAt(m_now));
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_EQ(changes[0].kind, Kind::Acknowledged);
    EXPECT_TRUE(m_book.alarms().empty());
    EXPECT_TRUE(m_book.acknowledge(Link, wallAt(m_now)).empty());
}

TEST_F(AlarmBookTest, AcknowledgedItIsQuietUntilItComesAgainOrGetsWorse) {
    until(1'000, {look(Link)});
    m_book.acknowledge(Link, wallAt(m_now));
    EXPECT_TRUE(until(5'000, {look(Link)}).empty());
    EXPECT_EQ(until(6'000, {act()}), std::vector{Kind::Raised}) << "worse";
    EXPECT_TRUE(m_book.alarms()[0].isLoud());
    m_book.acknowledge(Link, wallAt(m_now));
    EXPECT_TRUE(until(9'000, {look(Link)}).empty()) << "better, and still acknowledged";
    EXPECT_FALSE(m_book.alarms()[0].isLoud());
    until(15'000, {});
    EXPECT_EQ(until(16'000, {look(Link)}), std::vector{Kind::Raised}) << "again";
    EXPECT_FALSE(m_book.alarms()[0].acknowledged);
}

TEST_F(AlarmBookTest, OneMoreThanWasAcknowledgedIsRaisedAgainOneLessIsNot) {
    const auto scans = [](std::size_t count) {
        AlarmCause cause = look();
        cause.count = count;
        return cause;
    };
    until(1'000, {scans(1)});
    m_book.acknowledge(Battery, wallAt(m_now));
    EXPECT_TRUE(until(5'000, {scans(1)}).empty());
    EXPECT_EQ(until(6'000, {scans(2)}), std::vector{Kind::Raised});
    EXPECT_EQ(m_book.attentions(), 2u) << "it is told";
    EXPECT_FALSE(m_book.alarms()[0].acknowledged);
    m_book.acknowledge(Battery, wallAt(m_now));
    EXPECT_TRUE(until(7'000, {scans(1)}).empty());
    EXPECT_TRUE(m_book.alarms()[0].acknowledged);
    EXPECT_EQ(until(8'000, {scans(2)}), std::vector{Kind::Raised}) << "another one";
    EXPECT_TRUE(until(9'000, {scans(3)}).empty()) << "it stands there, to be looked at";
}

TEST_F(AlarmBookTest, TheNewestIsAcknowledgedFirst) {
    until(1'000, {look()});
    until(2'000, {look(), act()});
    ASSERT_EQ(m_book.alarms().size(), 2u);
    EXPECT_EQ(m_book.alarms()[0].cause.id, Link);
    EXPECT_EQ(m_book.acknowledgeNewest(wallAt(m_now)).at(0).cause.id, Link);
    EXPECT_EQ(m_book.acknowledgeNewest(wallAt(m_now)).at(0).cause.id, Battery);
    EXPECT_TRUE(m_book.acknowledgeNewest(wallAt(m_now)).empty());
}

TEST_F(AlarmBookTest, TextsFollowTheirNumbersWithoutBeingRaisedAgain) {
    until(1'000, {act()});
    AlarmCause later = act();
    later.value = 7.0;
    EXPECT_TRUE(until(2'000, {later}).empty());
    EXPECT_EQ(m_book.alarms()[0].cause.value, 7.0);
    EXPECT_EQ(m_book.alarms()[0].since, wallAt(400));
}

}  // namespace
}  // namespace leitstand::test
