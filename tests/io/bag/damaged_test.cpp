#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/bag/sample_bags.h"
#include "tests/support/attack.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;
using test::readAll;
using test::readText;
using test::writeText;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr std::size_t Page = 8'192;
constexpr std::uint64_t Events = 1'500;

/// A mission of one file, to be damaged anew by each test.
class DamagedBag : public testing::Test {
protected:
    DamagedBag() {
        test::writeSession(m_mission, 1, Events);
        m_content = readText(m_file);
    }

    /// Reads the mission as it is now; what comes must be as it was written, and nothing be changed by
    /// reading.
    std::vector<RawEvent> survivors() {
        const std::string before = test::fingerprint(m_mission);
        std::vector<RawEvent> events;
        m_problems.clear();
        auto reader = BagReader::open(m_mission);
        if (reader) {
            events = readAll(**reader);
            (void)(*reader)->lastUpTo("/leitstand/victims", Events);
            (void)(*reader)->event(Events / 2);
            (void)(*reader)->sequenceAt(test::at(7'000));
            m_problems = (*reader)->problems();
        } else {
            m_problems = {reader.error().text};
        }
        EXPECT_EQ(test::fingerprint(m_mission), before);
        EXPECT_TRUE(std::is_sorted(events.begin(), events.end(), [](const auto& a, const auto& b) {
            return a.sequence <= b.sequence;
        })) << "in order, each once";
        return events;
    }

    /// Writes @p content as the file.
    void put(const std::string& content) {
        fs::remove(m_file);
        writeText(m_file, content);
    }
    void garble(std::string& content, std::size_t page, unsigned seed) const {
        std::mt19937 random(seed);
        const std::size_t begin = page * Page, end = std::min(begin + Page, content.size());
        for (std::size_t i = begin; i < end; ++i) content[i] = static_cast<char>(random());
    }
    std::size_t pages() const { return m_content.size() / Page; }

    const test::TemporaryFolder m_folder;
    const fs::path m_mission = m_folder / "mission";
    const fs::path m_file = m_mission / "mission_0.db3";
    std::string m_content;
    std::vector<std::string> m_problems;
};

TEST_F(DamagedBag, TruncatedAnywhereGivesWhatIsThere) {
    for (const double part : {0.1, 0.3, 0.5, 0.77, 0.95, 0.999}) {
        const auto size = static_cast<std::size_t>(part * static_cast<double>(m_content.size()));
        put(m_content.substr(0, size));
        const auto events = survivors();
        EXPECT_EQ(test::differing(events), 0U);
        // The file grows as events come.
        EXPECT_GT(static_cast<double>(events.size()), (part - 0.1) * static_cast<double>(Events)) << part;
        EXPECT_THAT(m_problems, Contains(HasSubstr("page by page")));
    }
    test::tellAttack("log", "a log's file is cut off", 6, "all messages before the cut are read");
}

TEST_F(DamagedBag, GarbledPagesCostOnlyTheirOwn) {
    std::mt19937 random(11);
    for (unsigned round = 0; round < 30; ++round) {
        std::string content = m_content;
        const unsigned garbled = 1 + round % 5;
        for (unsigned i = 0; i < garbled; ++i) garble(content, 1 + random() % (pages() - 1), round * 10 + i);
        put(content);
        const auto events = survivors();
        EXPECT_GT(events.size(), Events - 60 * garbled) << round;
        // Without checksums, garbage within a message is not told: it is in its page, no more.
        EXPECT_LE(test::differing(events), 2 * garbled) << round;
    }
    test::tellAttack("log", "1 to 5 pages of a log are garbled", 30,
                     "at most what stood on those pages is missing or changed");
}

TEST_F(DamagedBag, EveryPageInTurn) {
    for (std::size_t page = 0; page < std::min<std::size_t>(pages(), 40); ++page) {
        std::string content = m_content;
        garble(content, page, 5);
        put(content);
        EXPECT_GT(survivors().size(), Events - 60) << "page " << page;
    }
}

TEST_F(DamagedBag, WithoutItsHeaderIsReadPageByPage) {
    std::string content = m_content;
    content.replace(0, Page, Page, '\0');
    put(content);
    const auto events = survivors();
    EXPECT_EQ(events.size(), Events);
    EXPECT_EQ(test::differing(events), 0U);
    EXPECT_THAT(m_problems, Contains(HasSubstr("1500 messages found")));
}

TEST_F(DamagedBag, FlippedBytesNeverCrash) {
    std::mt19937 random(12);
    for (int round = 0; round < 60; ++round) {
        std::string content = m_content;
        for (int i = 0; i < 30; ++i) {
            // Mostly where SQLite keeps its books: the first bytes of pages.
            const std::size_t page = random() % pages();
            content[page * Page + random() % (i % 3 == 0 ? Page : 16)] = static_cast<char>(random());
        }
        put(content);
        (void)survivors();
    }
    test::tellAttack("log", "30 bytes of a log are changed, mostly where SQLite keeps its books", 60,
                     "no crash; what is left is read");
}

TEST_F(DamagedBag, WithoutMetadataIsWhole) {
    fs::remove(m_mission / "metadata.yaml");
    EXPECT_EQ(survivors().size(), Events);
    EXPECT_THAT(m_problems, Contains(HasSubstr("metadata.yaml")));
    for (const char* text : {"", "[[[[", "a: [1, 2", "rosbag2_bagfile_information: 7", "\x01\xff\xfe"}) {
        writeText(m_mission / "metadata.yaml", text);
        EXPECT_EQ(survivors().size(), Events) << text;
        EXPECT_THAT(m_problems, Contains(HasSubstr("metadata.yaml"))) << text;
    }
}

TEST_F(DamagedBag, FilesThatAreNoDatabaseAreNamed) {
    for (const std::string& content : {std::string(), std::string("hello"), std::string(100'000, 'x')}) {
        put(content);
        EXPECT_THAT(survivors(), IsEmpty());
        ASSERT_THAT(m_problems, Not(IsEmpty()));
        EXPECT_THAT(m_problems.front(), testing::StartsWith(m_file.string()));
        EXPECT_THAT(m_problems.front(), HasSubstr("expected"));
    }
}

TEST_F(DamagedBag, ADamagedFileDoesNotHideTheOthers) {
    test::writeSession(m_mission, Events + 1, Events + 200);
    put(std::string(50'000, 'x'));
    EXPECT_EQ(survivors().size(), 200U);
    EXPECT_THAT(m_problems, Contains(HasSubstr("mission_0.db3")));
    test::writeSession(m_mission, Events + 201, Events + 300);  // recording goes on
    EXPECT_EQ(survivors().size(), 300U);
}

TEST_F(DamagedBag, ALogWithATornEndGivesWhatWasCommitted) {
    fs::remove_all(m_mission);
    test::writeUnclosedSession(m_mission, 1, 600);
    const fs::path log = m_mission / "mission_0.db3-wal";
    const std::string whole = readText(log);
    std::mt19937 random(13);
    for (int round = 0; round < 10; ++round) {
        std::string torn = whole;
        if (round % 2 == 0) {
            torn.resize(random() % torn.size());
        } else {
            for (int i = 0; i < 100; ++i) torn[random() % torn.size()] = static_cast<char>(random());
        }
        writeText(log, torn);
        EXPECT_EQ(test::differing(survivors()), 0U);
    }
    test::tellAttack("log", "the write-ahead log is torn or 100 bytes of it are changed", 10,
                     "no event is made up or changed");
    // With its file's head gone too, both are read page by page.
    writeText(log, whole);
    std::string content = readText(m_file);
    content.replace(0, 100, 100, 'x');
    put(content);
    const auto events = survivors();
    EXPECT_EQ(events.size(), 600U);
    EXPECT_EQ(test::differing(events), 0U);
}

}  // namespace
}  // namespace leitstand
