#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "tests/io/bag/sample_bags.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;

double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Makes a mission of @p rows messages of 50 kB, whose metadata do not count them, as a killed writer leaves
/// it.
void fillBag(const std::filesystem::path& mission, std::uint64_t rows) {
    test::writeSession(mission, 1, 100);
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((mission / "mission_0.db3").c_str(), &database), SQLITE_OK);
    const std::string fill = fmt::format(
        "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA cache_size = -64000; BEGIN;"
        "WITH RECURSIVE n(i) AS (SELECT 101 UNION ALL SELECT i + 1 FROM n WHERE i < {}) "
        "INSERT INTO messages SELECT i, CASE WHEN i % 2000 = 0 THEN 4 ELSE 1 + i % 3 END, "
        "{} + i * 10000000, zeroblob(50000) FROM n; "
        "UPDATE metadata SET metadata = replace(metadata, 'leitstand_counted_to: 100', "
        "'leitstand_counted_to: {}'); COMMIT",
        rows, test::at(0).time_since_epoch().count(), rows - 5'000);
    char* problem = nullptr;
    EXPECT_EQ(sqlite3_exec(database, fill.c_str(), nullptr, nullptr, &problem), SQLITE_OK) << problem;
    sqlite3_close(database);
}

/// Makes the next reads come from the disk.
void forgetCache(const std::filesystem::path& file) {
    const int descriptor = open(file.c_str(), O_RDONLY);
    fsync(descriptor);
    posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
    close(descriptor);
}

void openAndJump(std::uint64_t rows) {
    const test::TemporaryFolder folder;
    const double needed = 1.2 * 50'000.0 * static_cast<double>(rows);
    const double there = static_cast<double>(std::filesystem::space(folder.path()).available);
    if (there < needed) {
        GTEST_SKIP() << fmt::format("SKIPPED: {}: needs {:.1f} GB of free disk, found {:.1f} GB",
                                    folder.path().string(), needed * 1e-9, there * 1e-9);
    }
    const auto started = std::chrono::steady_clock::now();
    const auto mission = folder / "mission", file = mission / "mission_0.db3";
    fillBag(mission, rows);
    forgetCache(file);
    fmt::print("bag made in {:.0f} s\n", secondsSince(started));
    auto begin = std::chrono::steady_clock::now();
    const auto reader = test::opened(mission);
    const double opening = secondsSince(begin);
    ASSERT_NE(reader, nullptr);
    EXPECT_EQ(reader->lastSequence(), rows);
    std::mt19937 random(3);
    double worst = 0.0;
    for (int jump = 0; jump < 50; ++jump) {
        if (jump % 10 == 0) forgetCache(file);
        const std::uint64_t target = 2'000 + random() % (rows - 2'000);
        begin = std::chrono::steady_clock::now();
        const std::uint64_t sequence = reader->sequenceAt(test::at(static_cast<std::int64_t>(target) * 10));
        const auto checkpoint = reader->lastUpTo("/leitstand/victims", sequence);
        BagCursor cursor = reader->read({.fromSequence = sequence});
        const auto event = cursor.next();
        worst = std::max(worst, secondsSince(begin));
        ASSERT_TRUE(checkpoint && event);
        ASSERT_EQ(event->sequence, target);
        ASSERT_EQ(checkpoint->sequence, target / 2'000 * 2'000);
    }
    fmt::print("bag of {:.2f} GB, {} messages, cold: opened in {:.3f} s, jumps at worst {:.3f} s\n",
               static_cast<double>(std::filesystem::file_size(file)) * 1e-9, rows, opening, worst);
    EXPECT_LT(opening, 3.0);
    EXPECT_LT(worst, 1.0);
}

TEST(BagIndexLatency, OpensAndJumpsAtOnce) {
    openAndJump(8'000);
}

TEST(BagIndexLong, OpensTenGigabytesInThreeSecondsAndJumpsInOne) {
    openAndJump(200'000);
}

/// Writes @p chunk @p times to a plain file, fsynced as often as the bag commits.
double plainSeconds(const std::filesystem::path& file, const std::vector<std::byte>& chunk, int times) {
    const auto begin = std::chrono::steady_clock::now();
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    for (int i = 0; i < times; ++i) {
        EXPECT_EQ(write(descriptor, chunk.data(), chunk.size()), static_cast<ssize_t>(chunk.size()));
        if (i % 320 == 319) fsync(descriptor);
    }
    fsync(descriptor);
    close(descriptor);
    return secondsSince(begin);
}

TEST(BagThroughputLatency, SustainsFiftyMegabytesASecond) {
    constexpr int Messages = 6'000;
    const auto message = test::payload(50'000, 1);
    const test::TemporaryFolder folder;
    const double plain = plainSeconds(folder / "plain", *message, Messages);
    const auto writer = std::move(BagWriter::open(folder / "mission")).value();
    const auto begin = std::chrono::steady_clock::now();
    double slowest = 0.0;
    for (int i = 0; i < Messages; ++i) {
        while (writer->statistics().queuedBytes > 200'000'000) (void)writer->flush(100ms);
        const auto call = std::chrono::steady_clock::now();
        writer->write({0, test::at(i), "/kurt3d/points", "sensor_msgs/msg/PointCloud2", message});
        slowest = std::max(slowest, secondsSince(call));
    }
    EXPECT_TRUE(writer->flush(120s).ok());
    const double bag = secondsSince(begin);
    EXPECT_TRUE(writer->statistics().dropped.empty());
    const double megabytes = Messages * 0.05;
    fmt::print(
        "{:.0f} MB: bag {:.0f} MB/s, plain fsynced file {:.0f} MB/s, ratio {:.2f}; slowest write() {:.2f} "
        "ms\n",
        megabytes, megabytes / bag, megabytes / plain, plain / bag, slowest * 1e3);
    if (megabytes / bag <= 50.0 && megabytes / plain < 150.0) {
        GTEST_SKIP() << fmt::format(
            "SKIPPED: this disk is too slow to tell: bag {:.0f} MB/s, plain file {:.0f} MB/s",
            megabytes / bag, megabytes / plain);
    }
    EXPECT_GT(megabytes / bag, 50.0);
}

}  // namespace
}  // namespace leitstand
