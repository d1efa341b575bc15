#include "app/services/recorded/review_log.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/log/replay/bag_history.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "core/mission/state/fold.h"
#include "tests/app/review/written_mission.h"
#include "tests/io/bag/sample_bags.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using Mission = WrittenMission;

std::unique_ptr<ReviewLog> open(const std::filesystem::path& folder) {
    auto log = ReviewLog::open(folder);
    EXPECT_TRUE(log) << log.error().text;
    return log ? std::move(log).value() : nullptr;
}

/// All events of @p folder up to @p at, folded one by one.
MissionState foldedUpTo(const std::filesystem::path& folder, Time at) {
    const auto bag = BagReader::open(folder).value();
    EventDecoder decoder({Mission::robot()});
    MissionState state;
    BagCursor cursor = bag->read();
    while (const auto raw = cursor.next()) {
        if (raw->received > at) break;
        decoder.decode(*raw, [&](const Event& event) { state = fold(std::move(state), event); });
    }
    return state;
}

class ReviewLogTest : public testing::Test {
protected:
    void write(double checkpoints = 10.0) {
        WrittenMission mission(m_mission, checkpoints);
        writeMinute(mission);
    }
    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
};

TEST_F(ReviewLogTest, EveryMomentIsAsFoldingFromTheFirstEventMakesIt) {
    write();
    const auto log = open(m_mission);
    ASSERT_TRUE(log);
    EXPECT_EQ(log->first(), Mission::at(0.0));
    EXPECT_EQ(log->last(), Mission::at(60.0));
    // To and fro, beside and far, between events and on them.
    for (const double seconds : {0.0, 0.05, 33.3, 33.4, 33.2, 5.0, 59.99, 60.0, 20.0, 19.99, 90.0, 44.0}) {
        const Time at = Mission::at(seconds);
        EXPECT_EQ(serialised(log->stateAt(at)), serialised(foldedUpTo(m_mission, at))) << seconds;
    }
    EXPECT_EQ(log->stateAt(Mission::at(-1.0)).events, 0U);
    EXPECT_THAT(log->problems(), IsEmpty());
}

TEST_F(ReviewLogTest, WithoutCheckpointsItIsTheSame) {
    write(0.0);
    const auto log = open(m_mission);
    ASSERT_TRUE(log);
    for (const double seconds : {55.0, 12.0, 54.0}) {
        const Time at = Mission::at(seconds);
        EXPECT_EQ(serialised(log->stateAt(at)), serialised(foldedUpTo(m_mission, at))) << seconds;
    }
}

TEST_F(ReviewLogTest, GivesTheEventsBetweenTwoMoments) {
    write();
    const auto log = open(m_mission);
    ASSERT_TRUE(log);
    const auto count = [&](double after, double upTo) {
        int places = 0;
        log->events(Mission::at(after), Mission::at(upTo), [&](const Event& event) {
            EXPECT_GT(event.received, Mission::at(after));
            EXPECT_LE(event.received, Mission::at(upTo));
            if (event.topic == "/kurt3d/odom") ++places;
        });
        return places;
    };
    EXPECT_EQ(count(-5.0, 60.0), 601);
    EXPECT_EQ(count(9.95, 10.95), 10) << "over the border of two segments";
    EXPECT_EQ(count(3.0, 3.0), 0);
    EXPECT_EQ(count(4.0, 3.0), 0);
    EXPECT_EQ(count(60.0, 99.0), 0);
}

TEST_F(ReviewLogTest, FindsTheNewestOfATopicAlsoInASegmentBefore) {
    {
        WrittenMission mission(m_mission);
        mission.sayPicture(1.0, 50);
        for (int i = 0; i <= 400; ++i) mission.sayPlace(2.0 + 0.1 * i, 0.0);
    }
    const auto log = open(m_mission);
    ASSERT_TRUE(log);
    const std::string topic = Mission::robot().stream(StreamRole::Picture, "left")->topic;
    EXPECT_FALSE(log->newest(topic, Mission::at(0.9)));
    for (const double seconds : {1.0, 1.5, 41.0, 35.0}) {
        const auto found = log->newest(topic, Mission::at(seconds));
        ASSERT_TRUE(found) << seconds;
        EXPECT_EQ(found->received, Mission::at(1.0));
    }
    EXPECT_FALSE(log->newest("/nobody", Mission::at(41.0)));
}

TEST_F(ReviewLogTest, SaysWhyAMissionCannotBeReviewed) {
    const auto error = [](const std::filesystem::path& path) {
        const auto log = ReviewLog::open(path);
        return log ? std::string() : log.error().text;
    };
    EXPECT_THAT(error(m_folder / "nowhere"), HasSubstr("nowhere"));
    std::filesystem::create_directories(m_folder / "empty");
    EXPECT_THAT(error(m_folder / "empty"), HasSubstr("empty"));
    EXPECT_FALSE(isReviewable(m_folder / "empty"));
    std::filesystem::create_directories(m_folder / "broken");
    std::ofstream(m_folder / "broken/broken_0.db3") << "no database at all";
    EXPECT_THAT(error(m_folder / "broken"), HasSubstr("broken_0.db3"));
    EXPECT_FALSE(isReviewable(m_folder / "broken"));
    write();
    EXPECT_TRUE(isReviewable(m_mission));
}

TEST_F(ReviewLogTest, AFileCutOffIsReviewedAsFarAsItGoes) {
    write();
    for (const auto& entry : std::filesystem::directory_iterator(m_mission)) {
        if (entry.path().extension() == ".db3")
            std::filesystem::resize_file(entry.path(), std::filesystem::file_size(entry.path()) * 2 / 3);
    }
    const auto log = open(m_mission);
    ASSERT_TRUE(log);
    EXPECT_GT(log->stateAt(log->last()).events, 100U);
    EXPECT_FALSE(log->problems().empty());
}

TEST_F(ReviewLogTest, LeavesTheMissionAsItIs) {
    write();
    const std::string before = fingerprint(m_mission);
    {
        const auto log = open(m_mission);
        (void)log->stateAt(Mission::at(30.0));
    }
    EXPECT_EQ(fingerprint(m_mission), before);
}

}  // namespace
}  // namespace leitstand::test
