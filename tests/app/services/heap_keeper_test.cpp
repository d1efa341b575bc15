#include "app/services/heap_keeper.h"

#include <atomic>

#include <gtest/gtest.h>

#include "tests/support/wait.h"

namespace leitstand {
namespace {

TEST(HeapKeeper, WorksAgainAndAgain) {
    std::atomic<int> times = 0;
    const HeapKeeper keeper(std::chrono::milliseconds(1), [&times] { ++times; });
    EXPECT_TRUE(test::waitUntil([&] { return times >= 3; }, std::chrono::seconds(60)));
}

TEST(HeapKeeper, EndsWithoutWaitingForItsTime) {
    std::atomic<int> times = 0;
    {
        const HeapKeeper keeper(std::chrono::hours(1), [&times] { ++times; });
    }
    EXPECT_EQ(times, 0);
}

}  // namespace
}  // namespace leitstand
