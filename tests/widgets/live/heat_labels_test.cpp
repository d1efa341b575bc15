#include "widgets/models/camera/heat_labels.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

const QRectF Area(0, 30, 240, 180);

QSizeF sizeOf(double celsius) {
    return {celsius < 100.0 ? 116.0 : 124.0, 16.0};
}
HeatMark markAt(double x, double y, double side = 18.0, double celsius = 34.4) {
    return {{x, y, side, side}, celsius};
}
bool meet(const QRectF& one, const QRectF& other) {
    return one.intersects(other);
}

TEST(HeatLabels, StandAboveWhatTheyAreAbout) {
    const auto labels = heatLabels({markAt(100, 100)}, sizeOf, Area);
    ASSERT_EQ(labels.size(), 1U);
    EXPECT_EQ(labels[0].box, QRectF(51, 79, 116, 16));
    EXPECT_EQ(labels[0].celsius, 34.4);
}

TEST(HeatLabels, PartsOfOneBodyShareOne) {
    // hand, head, hand, as in the yellow arena's sample
    const auto labels = heatLabels(
        {markAt(78, 130, 18, 34.4), markAt(110, 113, 18, 34.6), markAt(128, 131, 18, 34.2)}, sizeOf, Area);
    ASSERT_EQ(labels.size(), 1U);
    EXPECT_EQ(labels[0].marks, 3);
    EXPECT_EQ(labels[0].celsius, 34.6);
    EXPECT_EQ(labels[0].about, QRectF(78, 113, 68, 36));
}

TEST(HeatLabels, OtherBodiesHaveTheirOwnBeside) {
    const auto labels = heatLabels({markAt(60, 100, 10), markAt(110, 100, 10)}, sizeOf, Area);
    ASSERT_EQ(labels.size(), 2U) << "40 px apart, 10 px small";
    EXPECT_FALSE(meet(labels[0].box, labels[1].box));
    EXPECT_EQ(labels[0].box.bottom(), 95.0);
}

TEST(HeatLabels, LeaveTheScaleAlone) {
    const QRectF scale(160, 30, 80, 180);
    const auto labels = heatLabels({markAt(180, 100)}, sizeOf, Area, {scale});
    ASSERT_EQ(labels.size(), 1U);
    EXPECT_FALSE(meet(labels[0].box, scale));
    EXPECT_FALSE(meet(labels[0].box, QRectF(180, 100, 18, 18)));
}

TEST(HeatLabels, LeaveTheScaleAloneAlsoAtTheEdge) {
    const QRectF scale(157, 30, 83, 180);
    for (const double y : {30.0, 110.0, 195.0}) {
        const auto labels = heatLabels({markAt(228, y, 12)}, sizeOf, Area, {scale});
        ASSERT_EQ(labels.size(), 1U);
        EXPECT_FALSE(meet(labels[0].box, scale)) << y;
    }
}

TEST(HeatLabels, NeverLieOnTheScaleHoweverSmallThePictureIs) {
    const QSizeF brief(54.0, 16.0);
    int labelled = 0;
    for (const double width : {120.0, 150.0, 190.0, 240.0}) {
        const QRectF area(0, 30, width, 0.75 * width), scale(width - 83.0, 30, 83.0, 0.75 * width);
        for (double x = 0.0; x < width - 20.0; x += 7.0) {
            for (double y = area.top(); y < area.bottom() - 20.0; y += 9.0) {
                const auto labels = heatLabels({markAt(x, y)}, sizeOf, area, {scale}, brief);
                for (const HeatLabel& label : labels) {
                    EXPECT_FALSE(meet(label.box, scale)) << width << ": " << x << ", " << y;
                    EXPECT_EQ(label.box.size(), label.brief ? brief : sizeOf(label.celsius));
                    labelled += label.brief ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(labelled, 50) << "brief words where the others have no room";
}

TEST(HeatLabels, AreNotWhereThereIsNoRoom) {
    EXPECT_TRUE(heatLabels({markAt(10, 40)}, sizeOf, {0, 30, 100, 180}).empty());
    EXPECT_TRUE(heatLabels({markAt(10, 40)}, sizeOf, {}).empty());
    const auto labels = heatLabels({markAt(5, 32, 4), markAt(60, 32, 4)}, sizeOf, {0, 30, 120, 20});
    EXPECT_EQ(labels.size(), 1U) << "one line has room for one";
}

TEST(HeatLabels, NeverLieOnEachOtherNorOutside) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(-10.0, 240.0), y(20.0, 210.0), side(3.0, 40.0),
        warm(28.0, 120.0);
    std::size_t most = 0;
    for (int run = 0; run < 300; ++run) {
        std::vector<HeatMark> marks;
        for (int i = 0; i <= run % 15; ++i)
            marks.push_back(markAt(x(random), y(random), side(random), warm(random)));
        const auto labels = heatLabels(marks, sizeOf, Area, {{170, 30, 70, 180}});
        most = std::max(most, labels.size());
        int covered = 0;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            EXPECT_TRUE(Area.contains(labels[i].box));
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(meet(labels[i].box, labels[j].box));
            covered += labels[i].marks;
        }
        EXPECT_LE(covered, static_cast<int>(marks.size()));
    }
    EXPECT_GE(most, 3U);
}

}  // namespace
}  // namespace leitstand
