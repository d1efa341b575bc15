#include "core/perception/pictures/content_hash.h"

#include <array>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

TEST(ContentHash, DiffersByAnyByteAndByLength) {
    std::array<std::byte, 29> bytes{};
    const std::uint64_t all = contentHash(bytes);
    EXPECT_EQ(contentHash(bytes), all);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        for (const int bit : {0, 7}) {
            bytes[i] = static_cast<std::byte>(1 << bit);
            EXPECT_NE(contentHash(bytes), all) << i;
            bytes[i] = {};
        }
    }
    EXPECT_NE(contentHash(std::span(bytes).first(28)), all);
}

}  // namespace
}  // namespace leitstand
