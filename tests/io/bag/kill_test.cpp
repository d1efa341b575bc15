#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <limits>
#include <random>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/io/bag/sample_bags.h"
#include "tests/support/attack.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;

Time now() {
    return std::chrono::time_point_cast<Time::duration>(std::chrono::system_clock::now());
}

/// A process that records numbered events, some 2 MB/s, until it is killed; tells by a byte that it began.
[[noreturn]] void record(const std::filesystem::path& mission, BagStorage storage, int notifyPipe) {
    auto opening = BagWriter::open(mission, {.storage = storage});
    if (!opening) _exit(1);
    const auto writer = std::move(opening).value();
    for (const TopicInfo& topic : test::sampleTopics()) writer->addTopic(topic);
    for (std::uint64_t i = writer->earlierSequence() + 1;; ++i) {
        RawEvent event = test::sampleEvent(i);
        event.received = now();
        writer->write(std::move(event));
        if (i % 10 == 0) std::this_thread::sleep_for(2ms);
        if (notifyPipe >= 0) (void)!write(notifyPipe, "", 1);
        notifyPipe = -1;
    }
}

/// Kills a recorder at @p rounds random moments, each resuming the same mission, and looks what is there. At
/// most the last @p mostMissing [s] are missing; infinite: not held, since a commit waits for the disk.
void killAndLook(BagStorage storage, int rounds, unsigned seed, double mostMissing) {
    const test::TemporaryFolder folder;
    std::mt19937 random(seed);
    std::uint64_t before = 0;
    double worst = 0.0;
    for (int round = 0; round < rounds; ++round) {
        int ends[2];
        ASSERT_EQ(pipe(ends), 0);
        const pid_t child = fork();
        if (child == 0) record(folder / "mission", storage, ends[1]);
        close(ends[1]);
        char begun = 0;
        EXPECT_EQ(read(ends[0], &begun, 1), 1) << "the recorder did not begin";
        close(ends[0]);
        // The moment is what is tested: from the first event on, through commits, checkpoints and metadata.
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 1'500));
        const Time killed = now();
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);

        const std::string files = test::fingerprint(folder / "mission");
        const auto reader = test::opened(folder / "mission");
        ASSERT_NE(reader, nullptr);
        EXPECT_EQ(reader->sessions().size(), static_cast<std::size_t>(round + 1));
        const auto events = test::readAll(*reader, {.fromSequence = before + 1});
        EXPECT_EQ(test::fingerprint(folder / "mission"), files);
        for (std::size_t i = 0; i < events.size(); ++i) ASSERT_EQ(events[i].sequence, before + 1 + i);
        const Time last = events.empty() ? Time{} : events.back().received;
        if (!events.empty()) {
            const double missing = std::chrono::duration<double>(killed - last).count();
            worst = std::max(worst, missing);
            EXPECT_LT(missing, mostMissing) << "round " << round;
            before = events.back().sequence;
        }
    }
    test::tellAttack("log",
                     std::string("kill -9 of the recorder at random moments") +
                         (storage == BagStorage::Mcap ? " (MCAP)" : ""),
                     static_cast<std::uint64_t>(rounds),
                     fmt::format("all missions open; at worst the last {:.2f} s are missing", worst));
}

TEST(KilledRecorder, LeavesWhatItCommittedWithoutAGapAtFiveMoments) {
    killAndLook(BagStorage::Sqlite, 5, 1, std::numeric_limits<double>::infinity());
}

TEST(KilledRecorder, LeavesAnMcapFileThatIsReadToTheLastCommitAtFiveMoments) {
    killAndLook(BagStorage::Mcap, 5, 4, std::numeric_limits<double>::infinity());
}

TEST(KilledRecorderLatency, LosesAtMostTheLastSecond) {
    killAndLook(BagStorage::Sqlite, 5, 3, 1.0);
}

TEST(KilledRecorderLong, LosesAtMostTheLastSecondAtFiftyMoments) {
    killAndLook(BagStorage::Sqlite, 50, 2, 1.0);
}

}  // namespace
}  // namespace leitstand
