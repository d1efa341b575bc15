#include "core/mapping/graph/map_parts.h"

#include <vector>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace leitstand
