#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/handin/writing/report_keeper.h"
#include "core/base/parallel.h"
#include "tests/app/report/sample_mission.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

TEST(ReportKeeper, WritesAtItsIntervalAndWhenAsked) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "mission", {.scans = 1});
    std::atomic<int> written = 0, failed = 0;
    const auto count = [&](const Result<ReportOutcome>& outcome) {
        ++(outcome.ok() && outcome->whole() ? written : failed);
    };
    {
        ReportKeeper keeper({.mission = folder / "mission",
                             .out = folder / "out",
                             .options = {},
                             .interval = std::chrono::milliseconds(1)},
                            count);
        EXPECT_TRUE(waitUntil([&] { return written >= 2; }, std::chrono::seconds(60)));
    }
    EXPECT_EQ(failed, 0);
    written = 0;
    {
        ReportKeeper keeper({.mission = folder / "mission",
                             .out = folder / "out",
                             .options = {},
                             .interval = std::chrono::hours(1)},
                            count);
        keeper.writeNow();
        EXPECT_TRUE(waitUntil([&] { return written >= 1; }, std::chrono::seconds(60)));
    }
    EXPECT_EQ(written, 1);
}

int niceOf(pid_t thread) {
    return ::getpriority(PRIO_PROCESS, static_cast<id_t>(thread));
}

TEST(ReportKeeper, GivesWayToWhatDrivesAndMaps) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "mission", {.scans = 1, .finds = false});
    std::atomic<int> keepers = -100, written = 0;
    ReportOptions options;
    options.pdf = [&](const ReportContent&) -> Result<std::string> {
        keepers = niceOf(::gettid());
        return Error{"none"};
    };
    ReportKeeper keeper({.mission = folder / "mission",
                         .out = folder / "out",
                         .options = options,
                         .interval = std::chrono::milliseconds(1)},
                        [&](const Result<ReportOutcome>&) { ++written; });
    EXPECT_TRUE(waitUntil([&] { return written >= 1; }, std::chrono::seconds(60)));
    const int own = niceOf(::gettid());
    EXPECT_EQ(keepers, std::max(own, 5)) << "the thread that writes";
    std::mutex mutex;
    std::set<int> shared;
    parallelFor(10'000, 1, 0, [&](std::size_t, std::size_t) {
        const std::lock_guard lock(mutex);
        shared.insert(niceOf(::gettid()));
    });
    EXPECT_EQ(shared, std::set<int>{own}) << "registration goes on as before";
}

TEST(ReportKeeper, TellsWhyThereIsNone) {
    const TemporaryFolder folder;
    std::atomic<int> failed = 0;
    ReportKeeper keeper({.mission = folder / "absent",
                         .out = folder / "out",
                         .options = {},
                         .interval = std::chrono::milliseconds(1)},
                        [&](const Result<ReportOutcome>& outcome) { failed += outcome.ok() ? 0 : 1; });
    EXPECT_TRUE(waitUntil([&] { return failed >= 1; }, std::chrono::seconds(60)));
}

}  // namespace
}  // namespace leitstand::test
