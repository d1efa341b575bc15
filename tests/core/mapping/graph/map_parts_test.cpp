#include "core/mapping/graph/map_parts.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/event/scan_links.h"

namespace leitstand {
namespace {

Link link(std::uint64_t from, std::uint64_t to, bool active = true) {
    Link made;
    made.from = from;
    made.to = to;
    made.active = active;
    return made;
}

TEST(MapParts, WhatActiveLinksJoinIsOnePart) {
    const std::vector<Link> links = {link(7, 9), link(2, 1), link(9, 8), link(3, 2), link(3, 8, false)};
    const MapParts parts(links);
    for (const std::uint64_t scan : {1U, 2U, 3U}) EXPECT_EQ(parts.lowest(scan), 1U) << scan;
    for (const std::uint64_t scan : {7U, 8U, 9U}) EXPECT_EQ(parts.lowest(scan), 7U) << scan;
    EXPECT_EQ(parts.lowest(4), 4U) << "no link has it";
}

TEST(MapParts, LinksMayComeInAnyOrder) {
    const std::vector<Link> links = {link(5, 6), link(3, 4), link(1, 2), link(6, 4), link(2, 5)};
    const MapParts parts(links);
    for (std::uint64_t scan = 1; scan <= 6; ++scan) EXPECT_EQ(parts.lowest(scan), 1U) << scan;
}

/// A part that begins with scan 1 and one that begins with scan 11, each a chain of @p length.
struct TwoChains {
    std::vector<ScanInPart> scans;
    std::vector<Link> links;

    explicit TwoChains(std::uint64_t length = 4) {
        for (const std::uint64_t first : {std::uint64_t{1}, std::uint64_t{11}}) {
            for (std::uint64_t i = 0; i < length; ++i) {
                scans.push_back({.id = first + i, .matched = i == 0 ? 0 : first, .begins = i == 0});
                if (first > 1) scans.back().enteredAt.translation().y() = -50.0;
                if (i > 0) add(first + i - 1, first + i, LinkKind::Match);
            }
        }
    }
    void add(std::uint64_t from, std::uint64_t to, LinkKind kind) {
        links.push_back(link(from, to));
        links.back().kind = kind;
        links.back().id = links.size();
    }
    [[nodiscard]] bool counts(std::size_t index) const {
        return links[index].active && !unheldLoops(links, scans).contains(links[index].id);
    }
};

TEST(MapParts, ALoopBetweenPartsCountsOnlyWhereSomethingElseHoldsThemTogether) {
    TwoChains map;
    const std::size_t loop = map.links.size();
    map.add(2, 13, LinkKind::Loop);
    EXPECT_FALSE(map.counts(loop)) << "what had joined them was taken back";
    map.add(1, 11, LinkKind::Operator);
    EXPECT_TRUE(map.counts(loop));
    map.links.back().active = false;
    EXPECT_FALSE(map.counts(loop));
}

TEST(MapParts, LoopsBetweenWhatBeganTwiceAtTheOriginCount) {
    TwoChains map;  // all was taken back, and the map begun anew where it had begun
    for (ScanInPart& scan : map.scans) scan.enteredAt = Pose::Identity();
    const std::size_t loop = map.links.size();
    map.add(2, 13, LinkKind::Loop);
    EXPECT_TRUE(map.counts(loop));
}

TEST(MapParts, LoopsWithinAPartAlwaysCount) {
    TwoChains map;
    const std::size_t loop = map.links.size();
    map.add(1, 4, LinkKind::Loop);
    EXPECT_TRUE(map.counts(loop));
    // Also where a decision has left its scans without what they hung on: no part begins there.
    map.links[1].active = false;
    EXPECT_TRUE(map.counts(loop));
}

}  // namespace
}  // namespace leitstand
