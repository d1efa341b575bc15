// What is left of a mission whose write-ahead log was lost, cut or broken, and what is told of it.
#include <algorithm>
#include <numeric>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/io/bag/sample_bags.h"
#include "tests/support/attack.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr std::uint64_t Written = 1'500;  // some 13 MB
constexpr std::uint64_t ACommit = 20;     // events

/// A mission as a killed writer leaves it, whose metadata.yaml is as young as it can be.
class LostLog : public testing::Test {
protected:
    LostLog() {
        BagWriterSettings settings;
        settings.metadataInterval = std::chrono::milliseconds(0);
        test::writeUnclosedSession(m_mission, 1, Written, settings, ACommit);
    }

    struct Found {
        std::vector<RawEvent> events;
        std::vector<std::string> problems;
        std::uint64_t counted = 0, missing = 0;
    };
    /// What can be read. Counts tell what is there, no more, and reading changes nothing.
    Found found() const {
        const std::string before = test::fingerprint(m_mission);
        Found found;
        const auto reader = test::opened(m_mission);
        if (!reader) return found;
        found.events = test::readAll(*reader);
        reader->count();
        for (const BagSession& session : reader->sessions()) {
            found.counted += session.messages.value_or(0);
            found.missing += session.missing;
        }
        std::uint64_t ofTopics = 0;
        for (const BagTopic& topic : reader->topics()) ofTopics += topic.messages.value_or(0);
        EXPECT_EQ(found.counted, found.events.size()) << "what is counted is there";
        EXPECT_EQ(ofTopics, found.events.size());
        EXPECT_EQ(test::differing(found.events), 0U);
        found.problems = reader->problems();
        EXPECT_EQ(test::fingerprint(m_mission), before);
        return found;
    }

    const test::TemporaryFolder m_folder;
    const fs::path m_mission = m_folder / "mission";
    const fs::path m_file = m_mission / "mission_0.db3", m_log = m_mission / "mission_0.db3-wal";
};

std::uint64_t bytesOf(std::uint64_t first, std::uint64_t last) {
    std::uint64_t bytes = 0;
    for (std::uint64_t i = first; i <= last; ++i) bytes += test::sampleEvent(i).cdr->size();
    return bytes;
}

TEST_F(LostLog, AWholeOneTellsNothing) {
    const Found found = this->found();
    EXPECT_EQ(found.events.size(), Written);
    EXPECT_EQ(found.missing, 0U);
    EXPECT_THAT(found.problems, IsEmpty());
}

TEST_F(LostLog, CostsFourMegabytesAtMostAndIsTold) {
    fs::remove(m_log);
    const Found found = this->found();
    ASSERT_LT(found.events.size(), Written) << "the log held something";
    const std::uint64_t lost = bytesOf(found.events.size() + 1, Written);
    EXPECT_LE(lost, 4U << 20U);
    EXPECT_EQ(found.missing, Written - found.events.size());
    EXPECT_THAT(found.problems, Contains(HasSubstr("mission_0.db3-wal")));
    EXPECT_THAT(found.problems, Contains(HasSubstr(fmt::format("{} are missing", found.missing))));
    test::tellAttack(
        "log", "the write-ahead log is deleted", 1,
        fmt::format("{} of {} events ({:.1f} of {:.1f} MB) are missing, which is told", found.missing,
                    Written, 1e-6 * double(lost), 1e-6 * double(bytesOf(1, Written))));
}

TEST_F(LostLog, IsToldWithoutMetadataFileToo) {
    fs::remove(m_log);
    fs::remove(m_mission / "metadata.yaml");
    EXPECT_THAT(found().problems, Contains(HasSubstr("what was written last may be missing")));
}

TEST_F(LostLog, StaysToldWhenTheMissionGoesOn) {
    fs::remove(m_log);
    const std::uint64_t missing = found().missing;
    ASSERT_GT(missing, 0U);
    for (int resumed = 1; resumed <= 2; ++resumed) {
        const auto writer = std::move(BagWriter::open(m_mission)).value();
        EXPECT_GE(writer->earlierSequence(), Written) << "a sequence is not given twice";
        for (const TopicInfo& topic : test::sampleTopics()) writer->addTopic(topic);
        for (int i = 1; i <= 10; ++i)
            writer->write(test::sampleEvent(writer->earlierSequence() + static_cast<std::uint64_t>(i)));
        ASSERT_TRUE(writer->close().ok());
        const Found after = found();
        EXPECT_EQ(after.missing, missing);
        EXPECT_THAT(after.problems, Contains(HasSubstr(fmt::format("{} are missing", missing))));
    }
}

TEST_F(LostLog, CountsThatNobodyCanHaveWrittenAreNotGoneOnFrom) {
    std::string metadata = test::readText(m_mission / "metadata.yaml");
    const auto counted = metadata.find("leitstand_counted_to: ");
    ASSERT_NE(counted, std::string::npos);
    const auto end = metadata.find('\n', counted);
    metadata.replace(counted, end - counted, "leitstand_counted_to: 999999999999999");
    test::writeText(m_mission / "metadata.yaml", metadata);
    const auto writer = std::move(BagWriter::open(m_mission)).value();
    EXPECT_EQ(writer->earlierSequence(), Written);
}

/// Frames of 8 KiB pages behind a header of 32 bytes.
constexpr std::size_t LogHeader = 32, LogFrame = 24 + 8'192;

TEST_F(LostLog, FramesBehindABrokenOneAreRead) {
    const std::string whole = test::readText(m_log);
    const std::uint64_t before = [&] {
        fs::remove(m_log);
        return found().events.size();
    }();
    const std::size_t frames = (whole.size() - LogHeader) / LogFrame;
    ASSERT_GT(frames, 50U);
    std::mt19937 random(3);
    std::uint64_t salvaged = 0, fewest = Written;
    constexpr int Rounds = 20;
    for (int round = 0; round < Rounds; ++round) {
        std::string broken = whole;
        // In turn: its page number, the numbers of its round, its checksum, its content, two at once.
        const std::size_t frame = LogHeader + LogFrame * (random() % (frames / 2));
        const std::size_t places[] = {0, 9, 17, 24 + random() % 8'192, 500};
        broken[frame + places[round % 5]] ^= '\x55';
        if (round % 5 == 4) broken[frame + 2 * LogFrame + 3'000] ^= '\x33';
        test::writeText(m_log, broken);
        const Found found = this->found();
        salvaged += found.events.size() - before;
        fewest = std::min<std::uint64_t>(fewest, found.events.size());
        EXPECT_GT(found.events.size(), Written - 2 * ACommit) << "round " << round;
        EXPECT_THAT(found.problems, Contains(HasSubstr("is broken"))) << "round " << round;
        EXPECT_EQ(found.missing, Written - found.events.size());
    }
    test::tellAttack("log", "a frame of the write-ahead log is broken", Rounds,
                     fmt::format("at most {} of {} events are missing; what is behind the frame is read",
                                 Written - fewest, Written));
}

/// Copies what the log of @p database holds into the database, and ends as one that is killed after it: the
/// log stays.
void checkpointAndDie(const fs::path& database) {
    const pid_t child = fork();
    if (child == 0) {
        sqlite3* opened = nullptr;
        const bool done =
            sqlite3_open(database.c_str(), &opened) == SQLITE_OK &&
            sqlite3_exec(opened, "PRAGMA wal_checkpoint(PASSIVE)", nullptr, nullptr, nullptr) == SQLITE_OK;
        _exit(done ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

// What SQLite reads before the broken frame is then older than the pages in the database, which it may not
// take for a database at all.
TEST_F(LostLog, AFrameThatBreaksAfterACheckpointIsToldAndCostsACommitAtMost) {
    ASSERT_NO_FATAL_FAILURE(checkpointAndDie(m_file));
    std::string log = test::readText(m_log);
    // Frames of the log's present round share two numbers with its header; older ones follow.
    std::size_t frames = 0;
    while (LogHeader + (frames + 1) * LogFrame <= log.size() &&
           log.compare(LogHeader + frames * LogFrame + 8, 8, log, 16, 8) == 0)
        ++frames;
    ASSERT_GT(frames, 50U);
    for (std::size_t broken = 0; broken + 20 < frames; broken += 13) {
        std::string changed = log;
        changed[LogHeader + LogFrame * broken] ^= '\x55';
        test::writeText(m_log, changed);
        const Found found = this->found();
        EXPECT_GT(found.events.size(), Written - ACommit) << broken;
        EXPECT_EQ(found.missing, Written - found.events.size());
        EXPECT_THAT(found.problems, Contains(HasSubstr(fmt::format("frame {} is broken", broken + 1))));
    }
}

TEST_F(LostLog, IsReadWithoutItsHeader) {
    std::string log = test::readText(m_log);
    for (const std::size_t size : {4U, 32U}) {
        log.replace(0, size, size, 'x');
        test::writeText(m_log, log);
        const Found found = this->found();
        EXPECT_GT(found.events.size(), Written - 2 * ACommit);
        EXPECT_THAT(found.problems, Contains(HasSubstr("its header is broken")));
    }
}

TEST_F(LostLog, ACutOffEndIsTold) {
    const std::string whole = test::readText(m_log);
    std::mt19937 random(4);
    constexpr int Rounds = 20;
    std::uint64_t silent = 0;
    for (int round = 0; round < Rounds; ++round) {
        const std::size_t size = random() % whole.size();
        test::writeText(m_log, whole.substr(0, size));
        const Found found = this->found();
        if (found.events.size() == Written) continue;  // cut within what an earlier round left
        silent += found.missing == 0 ? 1 : 0;
        EXPECT_EQ(found.missing, Written - found.events.size());
        EXPECT_THAT(found.problems, Contains(HasSubstr("are missing"))) << size;
    }
    test::tellAttack(
        "log", "the end of the write-ahead log is cut off", Rounds,
        fmt::format("what was committed before is read; {} times events were missing untold", silent));
    // Without counts, the log itself tells, as long as it is not cut just between two commits.
    fs::remove(m_mission / "metadata.yaml");
    test::writeText(m_log, whole.substr(0, LogHeader + LogFrame + LogFrame / 2));
    EXPECT_THAT(found().problems, Contains(HasSubstr("ends within what was being written")));
}

TEST_F(LostLog, GarbageInItNeverMakesEventsUp) {
    const std::string whole = test::readText(m_log);
    std::mt19937 random(5);
    constexpr int Rounds = 60;
    for (int round = 0; round < Rounds; ++round) {
        std::string garbled = whole;
        const int bytes = 1 << random() % 10;
        for (int i = 0; i < bytes; ++i) garbled[random() % garbled.size()] = static_cast<char>(random());
        if (round % 4 == 0) garbled.resize(random() % garbled.size());
        test::writeText(m_log, garbled);
        const Found found = this->found();
        EXPECT_LE(found.events.size() + found.missing, Written);
    }
    test::tellAttack("log", "random bytes of the write-ahead log are changed, up to 512 at once", Rounds,
                     "no crash, no event made up or changed, counts as read");
}

}  // namespace
}  // namespace leitstand
