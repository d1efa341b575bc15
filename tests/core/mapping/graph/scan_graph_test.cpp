#include "core/mapping/graph/scan_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

using testing::ElementsAre;
using testing::Key;
using testing::Pair;

Link link(std::uint64_t from, std::uint64_t to, double distance = 1.0) {
    Link made;
    made.from = from;
    made.to = to;
    made.pose.translation().x() = distance;
    return made;
}

ScanGraph chain(int scans) {
    ScanGraph graph;
    for (int i = 2; i <= scans; ++i)
        graph.add(link(static_cast<std::uint64_t>(i - 1), static_cast<std::uint64_t>(i)));
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
    graph.add(link(1, 10, 0.5));  // a loop
    EXPECT_THAT(graph.within(1, 1.5), ElementsAre(Pair(1, 0.0), Pair(2, 1.0), Pair(9, 1.5), Pair(10, 0.5)));
}

TEST(ScanGraph, ALinkThatIsTakenBackJoinsNothing) {
    ScanGraph graph = chain(10);
    const std::uint64_t loop = graph.add(link(1, 10, 0.5)).id;
    graph.setActive(loop, false);
    EXPECT_THAT(graph.within(1, 1.5), ElementsAre(Pair(1, 0.0), Pair(2, 1.0)));
    graph.setActive(loop, true);
    EXPECT_THAT(graph.within(1, 0.5), ElementsAre(Pair(1, 0.0), Pair(10, 0.5)));
}

TEST(ScanGraph, ALinkOfAKnownIdTakesThePlaceOfThatOne) {
    ScanGraph graph = chain(3);
    Link again = link(1, 3, 5.0);
    again.id = 1;
    graph.add(again);
    ASSERT_EQ(graph.links().size(), 2U);
    EXPECT_THAT(graph.within(1, 4.0), ElementsAre(Key(1)));
    EXPECT_THAT(graph.within(1, 6.0), ElementsAre(Key(1), Key(2), Key(3)));
    EXPECT_EQ(graph.add(link(1, 2)).id, 3U);
}

TEST(ScanGraph, ForgetsAScanWithItsLinks) {
    ScanGraph graph = chain(4);
    graph.forget(2);
    EXPECT_THAT(graph.within(1, 10.0), ElementsAre(Key(1)));
    EXPECT_THAT(graph.within(3, 10.0), ElementsAre(Key(3), Key(4)));
    ASSERT_EQ(graph.links().size(), 1U);
    EXPECT_EQ(graph.add(link(1, 3)).id, 4U) << "ids are not given twice";
}

TEST(ScanGraph, NumbersOfAnotherStationsLinksAreLeftToIt) {
    ScanGraph graph = chain(4);
    graph.beginBlock(1000);
    EXPECT_EQ(graph.add(link(1, 3)).id, 1001U);
    graph.beginBlock(1000);
    EXPECT_EQ(graph.add(link(1, 4)).id, 2001U);
}

}  // namespace
}  // namespace leitstand
