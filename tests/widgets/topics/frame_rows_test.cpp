// The tf tree in words.
#include "widgets/models/frames/frame_rows.h"

#include <chrono>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

constexpr Time Now{std::chrono::seconds(1'000)};

FrameRow row(const std::string& frame, const std::string& parent, int depth) {
    FrameRow made;
    made.node.frame = frame;
    made.node.parent = parent;
    made.node.topic = "/tf";
    made.node.received = Now;
    made.depth = depth;
    made.root = parent.empty();
    return made;
}

TEST(FrameLines, TellPlaceRateAndAge) {
    FrameRow base = row("base_link", "odom", 1);
    base.node.rate = 50.2;
    base.node.frameInParent.translation() = Eigen::Vector3d(1.0, -0.5, 0.25);
    FrameRow lidar = row("lidar", "base_link", 2);
    lidar.node.fixed = true;
    lidar.node.received = Now - std::chrono::seconds(100);
    const auto lines = frameLines({row("odom", "", 0), base, lidar}, Now);
    EXPECT_EQ(lines[0].tone, Tone::Muted);
    EXPECT_EQ(lines[1].frame, QStringLiteral("  base_link"));
    EXPECT_EQ(lines[1].rate, QStringLiteral("50 Hz"));
    EXPECT_EQ(lines[1].place, QStringLiteral("1.00  \u22120.50  0.25"));
    EXPECT_EQ(lines[1].age, QString());
    EXPECT_EQ(lines[2].rate, QStringLiteral("static"));
    EXPECT_EQ(lines[2].tone, Tone::Normal) << "a static one never gets old";
}

TEST(FrameLines, WhatIsWrongIsAmberAndTold) {
    FrameRow old = row("base_link", "odom", 1);
    old.node.received = Now - std::chrono::seconds(7);
    FrameRow disputed = row("arm", "base_link", 2);
    disputed.otherParent = "map";
    FrameRow circle = row("a", "b", 0);
    circle.circle = true;
    const std::vector<FrameRow> rows = {row("odom", "", 0), old, disputed, circle};
    const auto lines = frameLines(rows, Now);
    EXPECT_EQ(lines[1].tone, Tone::Attention);
    EXPECT_EQ(lines[1].age, QStringLiteral("7 s"));
    EXPECT_TRUE(lines[2].hint.contains(QStringLiteral("Also below map"))) << lines[2].hint.toStdString();
    EXPECT_TRUE(lines[3].hint.contains(QStringLiteral("above itself")));
    bool attention = false;
    const QString summary = framesSummary(rows, {"velodyne"}, attention);
    EXPECT_TRUE(attention);
    EXPECT_TRUE(summary.contains(QStringLiteral("velodyne"))) << summary.toStdString();
    (void)framesSummary({}, {}, attention);
    EXPECT_FALSE(attention);
}

}  // namespace
}  // namespace leitstand::test
