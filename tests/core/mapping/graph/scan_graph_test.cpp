#include "core/mapping/graph/scan_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

using testing::ElementsAre;
using testing::Key;
using testing::Pair;

ScanGraph chain(int scans) {
    ScanGraph graph;
    for (int i = 2; i <= scans; ++i)
        graph.connect(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(i - 1), 1.0);
    return graph;
}

TEST(ScanGraph, FindsWhatHangsTogetherOverSoMuchWay) {
    const ScanGraph graph = chain(10);
    EXPECT_THAT(graph.within(5, 2.0),
                ElementsAre(Pair(3, 2.0), Pair(4, 1.0), Pair(5, 0.0), Pair(6, 1.0), Pair(7, 2.0)));
    EXPECT_THAT(graph.within(99, 2.0), ElementsAre(Pair(99, 0.0))) << "of a scan that nobody knows, itself";
}

TEST(ScanGraph, TakesTheShortestWay) {
    ScanGraph graph = chain(10);
    graph.connect(1, 10, 0.5);  // a loop
    EXPECT_THAT(graph.within(1, 1.5), ElementsAre(Pair(1, 0.0), Pair(2, 1.0), Pair(9, 1.5), Pair(10, 0.5)));
}

TEST(ScanGraph, ForgetsAScanWithItsLinks) {
    ScanGraph graph = chain(4);
    Link link;
    link.from = 1;
    link.to = 2;
    graph.add(link);
    link.from = 3;
    link.to = 4;
    graph.add(link);
    graph.forget(2);
    EXPECT_THAT(graph.within(1, 10.0), ElementsAre(Key(1)));
    EXPECT_THAT(graph.within(3, 10.0), ElementsAre(Key(3), Key(4)));
    ASSERT_EQ(graph.links().size(), 1U);
    EXPECT_EQ(graph.links().front().id, 2U) << "ids are not given twice";
    graph.add(link);
    EXPECT_EQ(graph.links().back().id, 3U);
}

}  // namespace
}  // namespace leitstand
