#include "core/base/heap.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/resident_memory.h"

namespace leitstand::test {
namespace {

TEST(Heap, WhatIsFreeBetweenWhatStaysIsGivenBack) {
#if !defined(__GLIBC__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "SKIPPED: only glibc's own allocator gives memory back this way";
#endif
    constexpr std::size_t Block = 50'000, Blocks = 2'000;  // 100 MB
    std::vector<std::unique_ptr<std::vector<char>>> blocks;
    for (std::size_t i = 0; i < Blocks; ++i)
        blocks.push_back(std::make_unique<std::vector<char>>(Block, '\1'));
    for (std::size_t i = 0; i < Blocks; ++i) {
        if (i % 10 != 0) blocks[i].reset();
    }
    const double before = residentMegabytes();
    returnFreeHeap();
    EXPECT_LT(residentMegabytes(), before - 50.0);
    for (std::size_t i = 0; i < Blocks; i += 10) ASSERT_EQ(blocks[i]->back(), '\1');
}

}  // namespace
}  // namespace leitstand::test
