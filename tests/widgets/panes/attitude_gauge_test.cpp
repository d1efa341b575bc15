#include "widgets/drive/attitude_gauge.h"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "tests/widgets/panes/shown.h"

namespace leitstand::test {
namespace {

class AttitudeGauges : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override { useTheme(GetParam()); }
    [[nodiscard]] const ThemeColours& colours() const { return coloursOf(GetParam()); }
};

/// Where the horizon of @p figures and the dots meet the dial's rim on its left, upper half: rows above its
/// middle [px].
struct Rim {
    double horizon = 0.0, dots = 0.0;
};

Rim rimOf(const AttitudeFigures& figures, const ThemeColours& colours) {
    AttitudeGauge gauge;
    gauge.show(figures);
    constexpr int Width = 300, Height = 400;
    const QImage picture = pictureOf(gauge, {Width, Height}, {});
    const auto near = [&](int x, int y, const QColor& colour) {
        return countOf(picture.copy(x, y, 1, 1), colour, 40) == 1;
    };
    // The dial is as wide as the gauge: 140 around (150, 170).
    constexpr int Middle = 170;
    Rim rim;
    rim.dots = 1e9;
    int leftmost = Width;
    for (int y = 31; y < Middle + 30; ++y) {
        for (int x = 5; x < Width / 2; ++x) {
            if (y < Middle && near(x, y, colours.act)) rim.dots = std::min(rim.dots, double(Middle - y));
            if (near(x, y, colours.select) && x < leftmost) leftmost = x, rim.horizon = Middle - y;
        }
    }
    return rim;
}

TEST_P(AttitudeGauges, TheHorizonReachesTheDotsAtTheLimitOfRollAndOfPitch) {
    AttitudeFigures figures;
    figures.known = true;
    for (const auto& [maxRoll, maxPitch] : {std::pair(25.0, 25.0), {40.0, 25.0}, {25.0, 40.0}}) {
        figures.maxRoll = degrees(maxRoll);
        figures.maxPitch = degrees(maxPitch);
        for (const double share : {0.64, 1.0}) {
            const bool reached = share == 1.0;
            // Left side down: the horizon's left end rises. Nose down: all of it does.
            figures.roll = -share * figures.maxRoll;
            figures.pitch = 0.0;
            const Rim roll = rimOf(figures, colours());
            figures.roll = 0.0;
            figures.pitch = share * figures.maxPitch;
            const Rim pitch = rimOf(figures, colours());
            for (const auto& [rim, what] : {std::pair(roll, "roll"), {pitch, "pitch"}}) {
                ASSERT_LT(rim.dots, 140.0);
                if (reached)
                    EXPECT_NEAR(rim.horizon, rim.dots, 4.0) << what << ' ' << maxRoll << ' ' << maxPitch;
                else
                    EXPECT_LT(rim.horizon, rim.dots - 12.0) << what << ' ' << maxRoll << ' ' << maxPitch;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Themes, AttitudeGauges, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& one) { return one.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
