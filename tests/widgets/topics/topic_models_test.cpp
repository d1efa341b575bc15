#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "widgets/models/topics/topic_rows.h"

namespace leitstand::test {
namespace {

std::vector<TopicRow> rows() {
    return {{"/odom", "nav_msgs/msg/Odometry", "/base", true, {}},
            {"/cmd_vel", "geometry_msgs/msg/Twist", "/base", false, {}},
            {"/points", "sensor_msgs/msg/PointCloud2", "/lidar", true, "asked reliable"}};
}

TEST(TopicRows, TheFilterTakesAllWordsWhateverTheirCase) {
    EXPECT_EQ(filtered(rows(), "").size(), 3U);
    EXPECT_EQ(filtered(rows(), "BASE").size(), 2U);
    EXPECT_EQ(filtered(rows(), "base odometry").size(), 1U);
    EXPECT_TRUE(filtered(rows(), "base points").empty());
}

TEST(TopicRows, WhatNobodyPublishesIsPaleAndWhatCannotComeStandsOut) {
    TopicRowsModel model;
    model.show(rows());
    const auto toneOf = [&](int row) {
        return static_cast<Tone>(model.data(model.index(row, TopicRowsModel::Topic), ToneRole).toInt());
    };
    EXPECT_EQ(toneOf(0), Tone::Normal);
    EXPECT_EQ(toneOf(1), Tone::Muted);
    EXPECT_EQ(toneOf(2), Tone::Attention);
    const QString hint = model.data(model.index(2, 0), Qt::ToolTipRole).toString();
    EXPECT_TRUE(hint.contains("asked reliable")) << hint.toStdString();
}

TEST(FieldRows, AreIndentedByTheirLastPart) {
    FieldRowsModel model;
    model.show({{"pose", "", 0, false}, {"pose.x", "1.5", 1, true}, {"ranges[3]", "2", 1, true}});
    const auto text = [&](int row, int column) { return model.data(model.index(row, column)).toString(); };
    EXPECT_EQ(text(0, FieldRowsModel::Field), "pose");
    EXPECT_EQ(text(1, FieldRowsModel::Field), "  x");
    EXPECT_EQ(text(1, FieldRowsModel::Value), "1.5");
    EXPECT_EQ(text(2, FieldRowsModel::Field), "  [3]");
}

TEST(TopicSummary, TellsRateLoadAndAge) {
    EXPECT_EQ(topicSummary(9.98, 0.0123, 0.035), QStringLiteral("10.0 Hz · 0.012 Mbit/s · 35 ms ago"));
    EXPECT_EQ(topicSummary(0.2, 0.0, 4.6), QStringLiteral("0.2 Hz · 0.000 Mbit/s · 5 s ago"));
    EXPECT_EQ(topicSummary(0.0, 0.0, std::nullopt), "Nothing came yet");
}

}  // namespace
}  // namespace leitstand::test
