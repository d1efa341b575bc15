#include "widgets/models/camera/ring_layout.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

std::vector<Proximity> ringOf(const std::vector<double>& distances, double near = 0.3) {
    std::vector<Proximity> ring;
    const double span = 2.0 * std::numbers::pi / static_cast<double>(distances.size());
    for (std::size_t i = 0; i < distances.size(); ++i) {
        Proximity part;
        part.from = (static_cast<double>(i) - 0.5) * span;
        part.to = part.from + span;
        part.distance = distances[i];
        part.where = Eigen::Vector2d(distances[i], 0.0);
        part.nearness = distances[i] < near ? Nearness::Near : Nearness::Far;
        ring.push_back(part);
    }
    return ring;
}

TEST(RingLayout, TheRingKeepsOffTheModeAndTheWords) {
    // the picture of the Link layout: 384 x 270 px, a mode of 66 px, words of 46 px
    const QRectF picture(40, 10, 384, 270);
    const QRectF circle = ringCircle(picture, 76, 234);
    EXPECT_GE(circle.top(), 76 + 6.5);
    EXPECT_LE(circle.bottom(), 234 - 6.5);
    EXPECT_DOUBLE_EQ(circle.width(), circle.height());
    EXPECT_DOUBLE_EQ(circle.center().x(), picture.center().x());
    const QRectF free = ringCircle(picture, 10, 280);
    EXPECT_DOUBLE_EQ(free.width(), 2 * 0.34 * 270) << "where there is room it is a third of the picture";
    EXPECT_NEAR(free.center().y(), 10 + 0.58 * 270, 1e-9);
}

TEST(RingLayout, WithoutRoomThereIsNone) {
    EXPECT_TRUE(ringCircle({0, 0, 100, 60}, 40, 50).isEmpty());
    EXPECT_TRUE(ringCircle({}, 0, 0).isEmpty());
    EXPECT_TRUE(ringCircle({0, 0, 400, 300}, 200, 100).isEmpty());
}

TEST(RingLayout, FiguresOfWhatIsNearAndOfTheNearest) {
    const QRectF circle(100, 100, 300, 300);
    const auto calm = ringFigures(ringOf({1.0, 2.0, 0.8, 2.0, 2.0, 2.0, 2.0, 2.0}), circle, {60, 22});
    ASSERT_EQ(calm.size(), 1U);
    EXPECT_EQ(calm[0].part, 2U);
    EXPECT_FALSE(calm[0].loud);
    EXPECT_NEAR(calm[0].at.x(), 140.0, 1.0) << "the third part is at the left";
    EXPECT_NEAR(calm[0].at.y(), 250.0, 1.0);
    const auto loud = ringFigures(ringOf({0.2, 2.0, 0.1, 2.0, 0.25, 2.0, 2.0, 2.0}), circle, {60, 22});
    ASSERT_EQ(loud.size(), 3U);
    EXPECT_EQ(loud[0].part, 2U) << "the nearest first";
}

TEST(RingLayout, FiguresNeverLieOnEachOther) {
    const std::vector<Proximity> near = ringOf({0.21, 0.22, 0.23, 0.10, 0.25, 0.26, 0.27, 0.28});
    for (double side = 48; side < 400; side += 8) {
        const auto figures = ringFigures(near, {0, 0, side, side}, {60, 22});
        ASSERT_FALSE(figures.empty());
        EXPECT_EQ(figures.front().part, 3U) << "the nearest is there always";
        for (std::size_t i = 0; i < figures.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const QPointF off = figures[i].at - figures[j].at;
                EXPECT_TRUE(std::abs(off.x()) >= 60 || std::abs(off.y()) >= 22) << side;
            }
        }
    }
    EXPECT_EQ(ringFigures(near, {0, 0, 400, 400}, {60, 22}).size(), 8U);
    EXPECT_TRUE(ringFigures({}, {0, 0, 400, 400}, {60, 22}).empty());
}

}  // namespace
}  // namespace leitstand
