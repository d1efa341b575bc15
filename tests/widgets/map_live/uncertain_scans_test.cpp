#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/widgets/map_live/live_map.h"
#include "tests/widgets/map_view/shown_view.h"
#include "widgets/map_view/scene/points/map_colours.h"

namespace leitstand::test {
namespace {

/// Relative luminance (WCAG 2).
double luminance(const Rgba& colour) {
    const auto linear = [](std::uint8_t value) {
        const double share = value / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
}

double contrast(const Rgba& a, const Rgba& b) {
    const double one = luminance(a), other = luminance(b);
    return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

/// [degrees]
double hue(const Rgba& colour) {
    const double r = colour.r, g = colour.g, b = colour.b;
    return std::atan2(std::sqrt(3.0) * (g - b), 2.0 * r - g - b) * 180.0 / M_PI;
}

constexpr std::array Labels = {Label::Floor, Label::Wall, Label::Ceiling, Label::Unlabelled};

class UncertainScanColours : public ::testing::TestWithParam<Theme> {
protected:
    const MapColours& m_colours = mapColours(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Themes, UncertainScanColours, ::testing::Values(Theme::Dark, Theme::Light));

TEST_P(UncertainScanColours, AreToldFromTheWallAndTheBackground) {
    const Rgba wall = labelColour(Label::Wall);
    EXPECT_GE(contrast(m_colours.uncertainScan, m_colours.background), 3.0);
    EXPECT_GE(contrast(m_colours.uncertainScan, wall), 3.0);
    EXPECT_GE(contrast(m_colours.scanInQuestion, m_colours.background), 3.0);
    for (const Label label : Labels)
        EXPECT_GE(contrast(m_colours.scanInQuestion, dimmed(labelColour(label), GetParam())), 3.0)
            << static_cast<int>(label);
    EXPECT_GE(contrast(m_colours.scanInQuestion, dimmed(m_colours.ground, GetParam())), 3.0);
}

TEST_P(UncertainScanColours, HaveAHueThatNoLabelHas) {
    for (const Rgba& own : {m_colours.uncertainScan, m_colours.scanInQuestion}) {
        for (const Label label : {Label::Floor, Label::Wall, Label::Ceiling}) {
            const double apart = std::abs(std::remainder(hue(own) - hue(labelColour(label)), 360.0));
            EXPECT_GT(apart, 45.0) << static_cast<int>(label);
        }
    }
}

QRgb rgbOf(const Rgba& colour) {
    return qRgb(colour.r, colour.g, colour.b);
}

TEST(UncertainScans, AreVioletAndThinAndMarked) {
    const QRgb violet = rgbOf(mapColours(Theme::Dark).uncertainScan);
    ShownView view(liveRoom(false));
    const QImage calm = view->picture();
    EXPECT_EQ(countPixels(calm, violet, 6), 0);
    view->setMap(liveRoom(true));
    view.settle();
    const QImage doubted = view->picture();
    EXPECT_LT(countPixels(doubted, WallYellow), countPixels(calm, WallYellow));
    EXPECT_GT(countPixels(doubted, violet, 6), 500) << "its points, its outline, and where it was taken";
}

TEST(UncertainScans, AllElseIsDimmedWhileOneIsDecidedOn) {
    const QRgb question = rgbOf(mapColours(Theme::Dark).scanInQuestion);
    for (const MapLook look : {MapLook::Points, MapLook::Top}) {
        ShownView view(liveRoom(true), settingsOf(look));
        const QImage waits = view->picture();
        EXPECT_GT(countPixels(waits, WallYellow), 200);
        EXPECT_EQ(countPixels(waits, question, 6), 0);
        view->setHighlighted(2);
        view.settle();
        const QImage decided = view->picture();
        EXPECT_EQ(countPixels(decided, WallYellow), 0);
        EXPECT_GT(countPixels(decided, rgbOf(dimmed(labelColour(Label::Wall), Theme::Dark))), 100);
        EXPECT_GT(countPixels(decided, question, 6), 500);
        view->setHighlighted(1);
        view.settle();
        EXPECT_GT(countPixels(view->picture(), WallYellow), 200) << "that one fits";
    }
}

TEST(UncertainScans, ColourOnlyVoxelsOfTheirOwn) {
    auto map = std::make_shared<Map>(*liveRoom(true));
    map->scans[0].poseInMap = poseFrom({40, 0, 0}, 0, 0, 0) * map->scans[0].poseInMap;
    ShownView apart(map, voxelsOf(0.15));
    const auto violet = [&](const QImage& picture) {
        int found = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor colour(picture.pixel(x, y));
                found +=
                    colour.hsvHue() > 265 && colour.hsvHue() < 300 && colour.hsvSaturation() > 90 ? 1 : 0;
            }
        }
        return found;
    };
    EXPECT_GT(violet(apart->picture()), 200);
    ShownView together(liveRoom(true), voxelsOf(0.15));
    EXPECT_GT(countPixels(together->picture(), 0xFFDAB80F, 20), 50) << "walls that both saw stay yellow";
    together->setHighlighted(2);
    together.settle();
    EXPECT_EQ(countPixels(together->picture(), 0xFFDAB80F, 20), 0) << "but are dimmed";
}

}  // namespace
}  // namespace leitstand::test
