#include "widgets/models/camera/mode_badge.h"

#include <gtest/gtest.h>

namespace leitstand {
namespace {

/// Letters of a common shape.
QSizeF monospaced(const QString& text, int pixels) {
    return {0.75 * pixels * static_cast<double>(text.size()), 1.2 * pixels};
}

const ModeLabel Safe{ModeKind::Teleoperation, "SAFE TELEOPERATION", {}, "SAFE TELEOP"};

TEST(ModeBadge, IsLargeOnALargePicture) {
    const ModeBadge badge = modeBadge(Safe, {0, 30, 640, 450}, monospaced);
    EXPECT_EQ(badge.text, "SAFE TELEOPERATION");
    EXPECT_EQ(badge.pixels, 18);
    EXPECT_EQ(badge.box.top(), 38.0);
    EXPECT_EQ(badge.box.center().x(), 320.0);
}

TEST(ModeBadge, ShrinksToTheBorderThenToItsFirstLetters) {
    EXPECT_EQ(modeBadge(Safe, {0, 24, 160, 96}, monospaced).text, "SAFE TELEOPERATION");
    EXPECT_EQ(modeBadge(Safe, {0, 24, 160, 96}, monospaced).box.top(), 24.0);
    EXPECT_EQ(modeBadge(Safe, {0, 24, 140, 60}, monospaced).text, "SAFE TELEOP");
    EXPECT_EQ(modeBadge(Safe, {0, 24, 70, 40}, monospaced).text, "ST");
    EXPECT_EQ(modeBadge(Safe, {0, 24, 20, 10}, monospaced).text, "") << "there is no picture";
    const ModeLabel lost{ModeKind::Lost, "LINK LOST", {}, {}};
    EXPECT_EQ(modeBadge(lost, {0, 24, 60, 40}, monospaced).text, "LL");
}

TEST(ModeBadge, CoversAFifthAtMostAndCanBeRead) {
    for (double width = 20.0; width < 700.0; width += 13.0) {
        for (const double height : {0.2 * width, 0.5625 * width, 0.75 * width}) {
            const QRectF open(5, 30, width, height);
            const ModeBadge badge = modeBadge(Safe, open, monospaced);
            if (badge.text.isEmpty()) {
                EXPECT_LT(width * height, 2'500.0);
                continue;
            }
            EXPECT_LE(badge.box.width() * badge.box.height(), 0.2 * width * height);
            EXPECT_TRUE(open.contains(badge.box));
            EXPECT_GE(badge.pixels, 11);
        }
    }
}

}  // namespace
}  // namespace leitstand
