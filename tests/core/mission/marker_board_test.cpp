#include "core/mission/markers/marker_board.h"

#include <cmath>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

constexpr Time Now{std::chrono::seconds(1'000)};

Marker marker(int id, std::size_t points = 0) {
    Marker made;
    made.space = "a";
    made.id = id;
    made.points.resize(points, Eigen::Vector3d::Zero());
    return made;
}

TEST(MarkerBoard, KeepsTheNewestOfEachName) {
    MarkerBoard board;
    board.take({false, {marker(1), marker(2)}}, Now);
    Marker other = marker(2);
    other.text = "again";
    Marker gone = marker(1);
    gone.removed = true;
    board.take({false, {other, gone, marker(3)}}, Now);
    ASSERT_EQ(board.drawn.size(), 2U);
    EXPECT_EQ(board.drawn.at({"a", 2}).marker->text, "again");
    board.take({true, {marker(7)}}, Now);
    EXPECT_EQ(board.drawn.size(), 1U);
}

TEST(MarkerBoard, DropsWhatIsOver) {
    MarkerBoard board;
    Marker brief = marker(1);
    brief.lifetime = std::chrono::seconds(1);
    board.take({false, {brief, marker(2)}}, Now);
    EXPECT_FALSE(isOver(board.drawn.at({"a", 1}), Now + std::chrono::milliseconds(900)));
    EXPECT_TRUE(isOver(board.drawn.at({"a", 1}), Now + std::chrono::milliseconds(1100)));
    board.take({}, Now + std::chrono::seconds(2));
    EXPECT_EQ(board.drawn.size(), 1U);
}

TEST(MarkerBoard, IsBoundedAndDropsTheOldest) {
    MarkerBoard board;
    for (int i = 0; i < 3'000; ++i) board.take({false, {marker(i)}}, Now + std::chrono::seconds(i));
    EXPECT_EQ(board.drawn.size(), MarkerBoard::MostMarkers);
    EXPECT_FALSE(board.drawn.contains({"a", 999}));
    EXPECT_TRUE(board.drawn.contains({"a", 2'999}));
    board.take({true, {marker(1, 40'000)}}, Now);
    board.take({false, {marker(2, 20'000), marker(3, 10'000), marker(4, 60'000)}},
               Now + std::chrono::seconds(1));
    EXPECT_EQ(board.drawn.size(), 2U) << "the first made room, the last is too large for any";
    EXPECT_FALSE(board.drawn.contains({"a", 1}));
    EXPECT_TRUE(isBounded(board));
}

TEST(MarkerBoard, KnowsWhatCanBeDrawn) {
    EXPECT_TRUE(isDrawable(marker(1, 3)));
    Marker far = marker(1);
    far.markerInFrame.translation().x() = 1e7;
    EXPECT_FALSE(isDrawable(far));
    Marker nowhere = marker(1, 1);
    nowhere.points[0].z() = std::nan("");
    EXPECT_FALSE(isDrawable(nowhere));
    Marker odd = marker(1);
    odd.colour.g = std::nanf("");
    EXPECT_FALSE(isDrawable(odd));
}

}  // namespace
}  // namespace leitstand::test
