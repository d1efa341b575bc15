#include <sys/mount.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/bag/sample_bags.h"
#include "tests/support/attack.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;

/// A disk of a few megabytes of its own.
class FullDisk : public testing::TestWithParam<BagStorage> {
protected:
    void SetUp() override {
        std::filesystem::create_directory(m_disk);
        if (::mount("tmpfs", m_disk.c_str(), "tmpfs", 0, "size=24m") != 0) {
            GTEST_SKIP() << "SKIPPED: a small disk cannot be mounted (" << std::strerror(errno)
                         << "): this test needs root";
        }
        m_mounted = true;
    }
    void TearDown() override {
        if (m_mounted) ::umount2(m_disk.c_str(), MNT_DETACH);
    }

    /// Words for the table of attacks.
    static std::string kind() { return GetParam() == BagStorage::Mcap ? " (MCAP)" : ""; }

    bool waitFor(const std::function<bool()>& condition) {
        const auto deadline = std::chrono::steady_clock::now() + 20s;
        while (!condition()) {
            if (std::chrono::steady_clock::now() > deadline) return false;
            std::this_thread::yield();
        }
        return true;
    }

    const test::TemporaryFolder m_folder;
    const std::filesystem::path m_disk = m_folder / "disk";
    bool m_mounted = false;
};

TEST_P(FullDisk, TheBagStaysReadableAndWritingGoesOnWhenThereIsSpaceAgain) {
    std::string ballast;
    ballast.resize(12'000'000, 'b');
    test::writeText(m_disk / "ballast", ballast);
    std::atomic<bool> full = false;
    const auto mission = m_disk / "mission";
    BagWriterSettings settings;
    settings.storage = GetParam();
    settings.commitInterval = 20ms;
    settings.commitBytes = 1'000'000;
    settings.retryInterval = 20ms;
    auto opening = BagWriter::open(mission, settings, [&](const BagAlarm& alarm) {
        if (alarm.kind == BagAlarm::Kind::DiskFull) full = alarm.raised;
    });
    ASSERT_TRUE(opening.ok()) << opening.error().text;
    const auto writer = std::move(opening).value();
    for (const TopicInfo& topic : test::sampleTopics()) writer->addTopic(topic);
    std::uint64_t last = 0;
    const auto odometry = [&] {
        RawEvent event = test::sampleEvent(101, 20'000);  // of a topic that is not dropped
        event.sequence = ++last;
        writer->write(event);
        (void)writer->flush(100ms);
    };
    while (!full && last < 5'000) odometry();
    ASSERT_TRUE(full);
    const auto before = test::readAll(*test::opened(mission));
    EXPECT_GT(before.size(), 100U);
    for (int i = 0; i < 20; ++i) odometry();
    std::filesystem::remove(m_disk / "ballast");
    ASSERT_TRUE(waitFor([&] { return !full; }));
    const auto closed = writer->close();
    EXPECT_TRUE(closed.ok()) << closed.error().text;
    const auto reader = test::opened(mission);
    EXPECT_EQ(test::readAll(*reader).size(), last) << "nothing but pictures may be missing";
    EXPECT_THAT(reader->problems(), testing::IsEmpty());
    test::tellAttack("log", "the disk is full for a while" + kind(), 1,
                     fmt::format("all {} events are there once there is space, but for pictures", last));
}

TEST_P(FullDisk, ClosingWhileItIsFullLeavesAReadableBag) {
    const auto mission = m_disk / "mission";
    BagWriterSettings settings;
    settings.storage = GetParam();
    settings.commitInterval = 20ms;
    settings.retryInterval = 20ms;
    const auto writer = std::move(BagWriter::open(mission, settings)).value();
    for (std::uint64_t i = 1; i <= 1'500; ++i) writer->write(test::sampleEvent(i, 20'000));
    const auto closed = writer->close();
    EXPECT_FALSE(closed.ok());
    const auto reader = test::opened(mission);
    ASSERT_NE(reader, nullptr);
    const auto events = test::readAll(*reader);
    EXPECT_EQ(test::differing(events, 20'000), 0U);
    test::tellAttack("log", "the disk is full when the log is closed" + kind(), 1,
                     fmt::format("the loss is told; the {} events that had space are read", events.size()));
}

INSTANTIATE_TEST_SUITE_P(Storage, FullDisk, testing::Values(BagStorage::Sqlite, BagStorage::Mcap),
                         [](const auto& one) { return std::string(nameOf(one.param)); });

}  // namespace
}  // namespace leitstand
