#include "core/base/parallel.h"

#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

TEST(ParallelFor, VisitsEachIndexOnceInTheSameRangesWithAnyNumberOfThreads) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{100}, std::size_t{1'003}}) {
        for (const int threads : {0, 1, 2, 5}) {
            constexpr std::size_t Grain = 100;
            std::vector<int> visits(count, 0);
            std::vector<std::size_t> ends((count + Grain - 1) / Grain, 0);
            parallelFor(count, Grain, threads, [&](std::size_t first, std::size_t last) {
                ASSERT_EQ(first % Grain, 0u);
                for (std::size_t i = first; i < last; ++i) ++visits[i];
                ends[first / Grain] = last;
            });
            EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), std::size_t{0}), count);
            for (std::size_t i = 0; i < ends.size(); ++i)
                EXPECT_EQ(ends[i], std::min(count, (i + 1) * Grain));
        }
    }
}

TEST(ParallelFor, PassesAnExceptionOn) {
    for (const int threads : {1, 2}) {
        const auto failing = [](std::size_t first, std::size_t) {
            if (first >= 50) throw std::runtime_error("no");
        };
        EXPECT_THROW(parallelFor(100, 10, threads, failing), std::runtime_error);
    }
}

TEST(ParallelFor, NoThreadsMeansOnePerCore) {
    EXPECT_GE(threadCount(0), 1);
    EXPECT_EQ(threadCount(3), 3);
}

}  // namespace
}  // namespace leitstand
