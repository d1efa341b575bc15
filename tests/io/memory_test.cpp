#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <functional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/io/clouds/pcd.h"
#include "core/io/clouds/ply.h"
#include "core/io/clouds/scan_source.h"
#include "tests/io/file_checks.h"
#include "tests/io/sample_scans.h"

namespace leitstand {
namespace {

using test::TemporaryFolder;

constexpr std::uint64_t Overhead =
    4'000'000;  // buffers, allocator, code that is met for the first time [bytes]

#if defined(__SANITIZE_THREAD__)
constexpr bool ShadowsMemory = true;  ///< ThreadSanitizer keeps several bytes beside each one of ours
#else
constexpr bool ShadowsMemory = false;
#endif

/// Most memory that the process had in use so far [bytes].
std::uint64_t peakMemory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) return std::stoull(line.substr(6)) * 1024;
    }
    return 0;
}

struct Cost {
    std::uint64_t points = 0;
    std::uint64_t memory = 0;  ///< by which the peak rose while reading [bytes]
};

/// Reads @p file in a process of its own, whose peak begins with what is in use now.
Cost costOfReading(const std::filesystem::path& file) {
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        const std::uint64_t before = peakMemory();
        const auto read = readScan(file);
        const Cost cost{read.ok() ? read->scan.points.size() : 0, peakMemory() - before};
        const bool sent = write(ends[1], &cost, sizeof(cost)) == sizeof(cost);
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    Cost cost;
    const bool received = read(ends[0], &cost, sizeof(cost)) == sizeof(cost);
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return received ? cost : Cost{};
}

/// Writes the lines of a scan over and over until the file has about @p size bytes; tells how many points.
std::uint64_t writeLongText(const std::filesystem::path& file, std::uint64_t size) {
    const Scan scan = test::sampleScan(Sweep::Tilting, 60, 120);
    std::string block;
    for (const Eigen::Vector3f& point : scan.points) {
        block += fmt::format("{:.5f} {:.5f} {:.5f}\n", point.x() * 100, point.y() * 100, point.z() * 100);
    }
    std::ofstream out(file, std::ios::binary);
    std::uint64_t blocks = 0;
    for (; blocks * block.size() < size; ++blocks) out << block;
    return blocks * scan.points.size();
}

void expectPointsHeldOnce(const std::filesystem::path& file, std::uint64_t points) {
    const Cost cost = costOfReading(file);
    EXPECT_EQ(cost.points, points);
    // A sanitizer keeps a byte about every eight.
    EXPECT_LT(cost.memory, points * sizeof(Eigen::Vector3f) * 5 / 4 + Overhead);
    fmt::print("{}: {:.1f} MB of file, {:.1f} MB of points, {:.1f} MB more memory at the peak\n",
               file.extension().string(), static_cast<double>(std::filesystem::file_size(file)) / 1e6,
               static_cast<double>(points * sizeof(Eigen::Vector3f)) / 1e6,
               static_cast<double>(cost.memory) / 1e6);
}

TEST(Memory, TextIsNotHeldBesideItsPoints) {
    if (ShadowsMemory) GTEST_SKIP() << "SKIPPED: ThreadSanitizer keeps memory of its own";
    const TemporaryFolder folder;
    for (const std::string name : {"scan000.3d", "a.xyz"}) {
        const std::uint64_t points = writeLongText(folder / name, 30'000'000);
        expectPointsHeldOnce(folder / name, points);
    }
}

TEST(Memory, ABinaryBodyIsNotHeldBesideItsPoints) {
    if (ShadowsMemory) GTEST_SKIP() << "SKIPPED: ThreadSanitizer keeps memory of its own";
    const TemporaryFolder folder;
    Scan scan;
    scan.points.assign(1'500'000, Eigen::Vector3f(1, 2, 3));
    for (const std::string name : {"a.pcd", "a.ply"}) {
        const bool pcd = name == "a.pcd";
        ASSERT_TRUE((pcd ? writePcd(folder / name, scan) : writePly(folder / name, scan)).ok());
        expectPointsHeldOnce(folder / name, scan.points.size());
    }
}

TEST(Memory, LongTextOf200MegabytesIsNotHeldBesideItsPoints) {
    if (ShadowsMemory) GTEST_SKIP() << "SKIPPED: ThreadSanitizer keeps memory of its own";
    const TemporaryFolder folder;
    const std::uint64_t points = writeLongText(folder / "scan000.3d", 200'000'000);
    expectPointsHeldOnce(folder / "scan000.3d", points);
}

}  // namespace
}  // namespace leitstand
