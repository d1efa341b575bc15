#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "transport/screen/screen.h"

namespace leitstand::test {
namespace {

/// The datagrams of a seed of fuzz_screen, with the byte that stands for the sender.
std::vector<std::pair<unsigned, std::vector<std::byte>>> datagramsOf(const std::string& seed) {
    std::vector<std::pair<unsigned, std::vector<std::byte>>> all;
    for (std::size_t at = 1; at + 3 <= seed.size();) {
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(seed[at + i]); };
        const std::size_t length = std::min<std::size_t>(byte(1) | byte(2) << 8, seed.size() - at - 3);
        const auto* from = reinterpret_cast<const std::byte*>(seed.data()) + at + 3;
        all.emplace_back(byte(0), std::vector<std::byte>(from, from + length));
        at += 3 + length;
    }
    return all;
}

// Recorded traffic stays what passes, whatever becomes of the screen.
TEST(ScreenSeeds, RecordedTrafficOfBothLibrariesPasses) {
    const auto folder = std::filesystem::path(sourceFolder()) / "fuzz" / "corpus" / "screen";
    int seeds = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream in(entry.path(), std::ios::binary);
        const std::string seed{std::istreambuf_iterator<char>(in), {}};
        ASSERT_FALSE(seed.empty());
        screen::Screen gate({.encrypted = (seed[0] & 1) != 0});
        ++seeds;
        for (const auto& [sender, bytes] : datagramsOf(seed)) {
            screen::Place place;
            place.address[12] = 127;
            place.port = static_cast<std::uint16_t>(sender);
            EXPECT_TRUE(gate.passes(bytes, place)) << entry.path() << ": " << gate.lastFault();
        }
    }
    EXPECT_GE(seeds, 3);
}

}  // namespace
}  // namespace leitstand::test
