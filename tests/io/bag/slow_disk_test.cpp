#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/station/alarms/log_format.h"
#include "tests/io/bag/sample_bags.h"
#include "tests/io/bag/slow_store.h"

namespace leitstand {
namespace {

using test::at;
using testing::HasSubstr;
using namespace std::chrono_literals;

constexpr const char* Pictures = "/kurt3d/left/image/compressed";

class SlowDisk : public testing::Test {
protected:
    SlowDisk() { start(); }

    void start() {
        BagWriterSettings settings;
        settings.commitInterval = 10ms;
        settings.commitBytes = 1'000'000;
        settings.droppableQueueBytes = 200'000;
        settings.queueBytes = 1'000'000;
        settings.retryInterval = 10ms;
        settings.metadataInterval = 1h;
        m_writer = BagWriter::over(std::make_unique<test::TestStore>(m_disk), settings,
                                   [this](const BagAlarm& alarm) {
                                       {
                                           const std::scoped_lock lock(m_mutex);
                                           m_alarms.push_back(alarm);
                                       }
                                       m_changed.notify_all();
                                   });
        for (const TopicInfo& topic : test::sampleTopics()) m_writer->addTopic(topic);
        EXPECT_TRUE(m_writer->flush().ok());
    }

    void write(const char* topic, std::size_t size) {
        const bool picture = std::string(topic) == Pictures;
        m_writer->write({0, at(1), topic,
                         picture ? "sensor_msgs/msg/CompressedImage" : "sensor_msgs/msg/PointCloud2",
                         test::payload(size, 1)});
    }

    /// Waits for an alarm to begin or end.
    std::optional<BagAlarm> alarm(BagAlarm::Kind kind, bool raised) {
        std::unique_lock lock(m_mutex);
        const auto found = [&] {
            return std::find_if(m_alarms.begin(), m_alarms.end(), [&](const BagAlarm& one) {
                return one.kind == kind && one.raised == raised;
            });
        };
        m_changed.wait_for(lock, 20s, [&] { return found() != m_alarms.end(); });
        return found() == m_alarms.end() ? std::nullopt : std::optional(*found());
    }

    std::size_t stored(const std::string& topic) {
        const auto events = m_disk->events();
        return static_cast<std::size_t>(std::count_if(
            events.begin(), events.end(), [&](const RawEvent& event) { return event.topic == topic; }));
    }

    std::shared_ptr<test::TestDisk> m_disk = std::make_shared<test::TestDisk>();
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<BagAlarm> m_alarms;
    std::unique_ptr<BagWriter> m_writer;
};

TEST_F(SlowDisk, DropsPicturesFirstCountsThemAndNeverBlocks) {
    m_disk->hold(true);
    const auto before = std::chrono::steady_clock::now();
    for (int i = 0; i < 40; ++i) {
        write(Pictures, 20'000);
        write("/kurt3d/points", 10'000);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - before, 2s);  // the disk stands still all the while
    const auto slow = alarm(BagAlarm::Kind::DiskSlow, true);
    ASSERT_TRUE(slow.has_value());
    EXPECT_THAT(log_format::message(slow->text), HasSubstr("does not keep up"));
    EXPECT_STREQ(log_format::newsIn(slow->text).phrase->code, log_format::DiskSlow.code);
    m_disk->hold(false);
    ASSERT_TRUE(m_writer->flush().ok());
    EXPECT_EQ(stored("/kurt3d/points"), 40U);
    const auto dropped = m_writer->statistics().dropped;
    EXPECT_FALSE(dropped.contains("/kurt3d/points"));
    EXPECT_GT(dropped.at(Pictures), 25U);
    EXPECT_EQ(stored(Pictures) + dropped.at(Pictures), 40U);
    const auto over = alarm(BagAlarm::Kind::DiskSlow, false);
    ASSERT_TRUE(over.has_value());
    EXPECT_THAT(log_format::message(over->text), HasSubstr("keeps up again"));
    EXPECT_STREQ(log_format::newsIn(over->text).phrase->code, log_format::DiskKeepsUp.code);
}

TEST_F(SlowDisk, WhatAPersonDidWaitsForNoInterval) {
    BagWriterSettings settings;
    settings.commitInterval = 1h;
    settings.metadataInterval = 1h;
    const auto disk = std::make_shared<test::TestDisk>();
    const auto writer = BagWriter::over(std::make_unique<test::TestStore>(disk), settings);
    TopicInfo finds;
    finds.name = "/leitstand/victims";
    finds.type = "leitstand_msgs/msg/Victim";
    finds.urgent = true;
    writer->addTopic(finds);
    ASSERT_TRUE(writer->flush().ok());
    writer->write({0, at(1), "/kurt3d/points", "sensor_msgs/msg/PointCloud2", test::payload(100, 1)});
    writer->write({0, at(2), finds.name, finds.type, test::payload(100, 2)});
    writer->write({0, at(3), "/kurt3d/points", "sensor_msgs/msg/PointCloud2", test::payload(100, 3)});
    // Nobody asks for it: the find is on the disk, and what came before it.
    ASSERT_TRUE(disk->waitForEvents(2));
    EXPECT_EQ(disk->events()[1].topic, finds.name);
}

TEST_F(SlowDisk, LosesTheRestOnlyBeyondTheStatedBoundAndSaysSo) {
    m_disk->hold(true);
    for (int i = 0; i < 150; ++i) write("/kurt3d/points", 10'000);
    ASSERT_TRUE(alarm(BagAlarm::Kind::EventsLost, true).has_value());
    EXPECT_LE(m_writer->statistics().queuedBytes, 1'000'000U);
    m_disk->hold(false);
    ASSERT_TRUE(m_writer->flush().ok());
    const std::uint64_t lost = m_writer->statistics().dropped.at("/kurt3d/points");
    EXPECT_GT(lost, 40U);
    EXPECT_EQ(stored("/kurt3d/points") + lost, 150U);
}

TEST_F(SlowDisk, WhenFullEventsWaitAndAreWrittenOnceThereIsSpace) {
    m_disk->full = true;
    write("/kurt3d/points", 10'000);
    write(Pictures, 10'000);
    const auto full = alarm(BagAlarm::Kind::DiskFull, true);
    ASSERT_TRUE(full.has_value());
    EXPECT_EQ(full->minutesLeft, 0.0);
    write("/kurt3d/points", 10'000);
    EXPECT_THAT(m_writer->statistics().problem, HasSubstr("no space"));
    EXPECT_EQ(stored("/kurt3d/points"), 0U);
    m_disk->full = false;
    ASSERT_TRUE(m_writer->flush().ok());
    EXPECT_EQ(stored("/kurt3d/points"), 2U);
    EXPECT_EQ(m_writer->statistics().dropped.at(Pictures), 1U);
    EXPECT_TRUE(alarm(BagAlarm::Kind::DiskFull, false).has_value());
    EXPECT_EQ(m_writer->statistics().problem, "");
}

TEST_F(SlowDisk, ClosingOnAFullDiskEndsAndTellsWhatIsLost) {
    m_disk->full = true;
    write("/kurt3d/points", 10'000);
    const auto closed = m_writer->close();
    ASSERT_FALSE(closed.ok());
    EXPECT_THAT(closed.error().text, HasSubstr("1 events are lost"));
}

TEST_F(SlowDisk, ClosingOnAFullDiskDoesNotWaitForEveryCommit) {
    BagWriterSettings patient;
    patient.retryInterval = 1h;
    patient.commitBytes = 1;  // a commit an event
    const auto disk = std::make_shared<test::TestDisk>();
    const auto writer = BagWriter::over(std::make_unique<test::TestStore>(disk), patient);
    ASSERT_TRUE(writer->flush().ok());
    disk->full = true;
    for (int i = 0; i < 20; ++i) {
        writer->write({0, at(1), "/kurt3d/points", "sensor_msgs/msg/PointCloud2", test::payload(10, 1)});
    }
    const auto closed = writer->close();
    ASSERT_FALSE(closed.ok());
    EXPECT_THAT(closed.error().text, HasSubstr("20 events are lost"));
}

TEST_F(SlowDisk, FlushDoesNotTakeDroppedPicturesForWhatIsOnTheDisk) {
    m_disk->full = true;
    write("/kurt3d/points", 10'000);
    ASSERT_TRUE(alarm(BagAlarm::Kind::DiskFull, true).has_value());
    std::jthread pictures([this](const std::stop_token& stop) {
        while (!stop.stop_requested()) write(Pictures, 10'000);
    });
    EXPECT_FALSE(m_writer->flush(100ms).ok());
    m_disk->full = false;
    EXPECT_TRUE(m_writer->flush().ok());
    EXPECT_EQ(stored("/kurt3d/points"), 1U);
}

TEST(GroupCommitLatency, NoEventWaitsLongerThanHalfASecond) {
    const auto disk = std::make_shared<test::TestDisk>();
    const auto writer = BagWriter::over(std::make_unique<test::TestStore>(disk), {});
    double worst = 0.0;
    for (int round = 1; round <= 5; ++round) {
        const auto begin = std::chrono::steady_clock::now();
        writer->write({0, at(1), "/kurt3d/odom", "nav_msgs/msg/Odometry", test::payload(700, 1)});
        ASSERT_TRUE(disk->waitForCommits(round));
        const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
        worst = std::max(worst, waited.count());
    }
    fmt::print("an event waited at worst {:.3f} s for its commit\n", worst);
    EXPECT_LT(worst, 0.5);
}

TEST_F(SlowDisk, ABrokenDiskIsToldAndTriedAgain) {
    m_disk->broken = true;
    write("/kurt3d/points", 10'000);
    const auto failed = alarm(BagAlarm::Kind::Failed, true);
    ASSERT_TRUE(failed.has_value());
    EXPECT_THAT(failed->text, HasSubstr("input/output error"));
    m_disk->broken = false;
    ASSERT_TRUE(m_writer->flush().ok());
    EXPECT_EQ(stored("/kurt3d/points"), 1U);
    const auto over = alarm(BagAlarm::Kind::Failed, false);
    ASSERT_TRUE(over.has_value());
    EXPECT_THAT(log_format::message(over->text), HasSubstr("written again"));
}

TEST_F(SlowDisk, AnEventThatCannotBeWrittenCostsNoOther) {
    m_disk->refused = 2;
    for (int i = 0; i < 3; ++i) write("/kurt3d/points", 100);
    ASSERT_TRUE(m_writer->flush().ok());
    EXPECT_EQ(stored("/kurt3d/points"), 2U);
    EXPECT_EQ(m_writer->statistics().dropped.at("/kurt3d/points"), 1U);
}

TEST_F(SlowDisk, TheAlarmTellsTheMinutesLeft) {
    m_disk->freeBytes = 3'000'000;
    std::optional<BagAlarm> filling;
    std::jthread asks([&] { filling = alarm(BagAlarm::Kind::DiskFilling, true); });
    std::jthread writes([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            write("/kurt3d/points", 10'000);
            (void)m_writer->flush();
        }
    });
    asks.join();
    ASSERT_TRUE(filling.has_value());
    EXPECT_GT(filling->minutesLeft, 0.0);
    EXPECT_LT(filling->minutesLeft, 10.0);
    EXPECT_THAT(filling->text, HasSubstr("minutes"));
}

}  // namespace
}  // namespace leitstand
