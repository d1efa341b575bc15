#include "widgets/models/live/robots/stream_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QAbstractItemModelTester>
#include <QLocale>
#include <QSignalSpy>

#include "core/event/stream_role.h"

namespace leitstand {
namespace {

StreamRow row(const std::string& topic = "/kurt3d/left", StreamRole role = StreamRole::Picture) {
    StreamRow row;
    row.face = {"kurt3d", "K", "Kurt3D", 0};
    row.type = "CompressedImage";
    row.settable = true;
    row.stream.role = role;
    row.stream.sensor = "left";
    row.stream.topic = topic;
    row.stream.samples = 100;
    row.stream.rate = 12.04;
    row.stream.expectedRate = 15.0;
    row.stream.age = 0.064;
    row.stream.megabitsPerSecond = 0.6;
    row.stream.steady = true;
    return row;
}

class StreamTableTest : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
    [[nodiscard]] std::string text(int column) const {
        return table.data(table.index(0, column)).toString().toStdString();
    }
    StreamTable table;
    QAbstractItemModelTester tester{&table};
};

TEST_F(StreamTableTest, ARowTellsWhatComes) {
    table.setRows({row()});
    EXPECT_EQ(text(StreamTable::Name), "K  left pictures");
    EXPECT_EQ(text(StreamTable::Rate), "12 / 15");
    EXPECT_EQ(text(StreamTable::Load), "600");
    EXPECT_EQ(text(StreamTable::Age), "64 ms");
    EXPECT_EQ(text(StreamTable::Loss), "0 %");
    EXPECT_EQ(text(StreamTable::Setting), "") << "as the robot likes";
}

TEST_F(StreamTableTest, WhatNeverCameHasDashesAndWhatIsOffSaysSo) {
    StreamRow silent = row();
    silent.stream = {};
    silent.stream.role = StreamRole::Points;
    table.setRows({silent});
    EXPECT_EQ(text(StreamTable::Rate), "–");
    EXPECT_EQ(text(StreamTable::Age), "–");
    EXPECT_EQ(toneOf(silent), Tone::Muted);
    StreamRow off = row();
    off.stream.paused = true;
    EXPECT_EQ(streamRateText(off.stream), "off");
    off.stream.paused = false;
    off.stream.steady = false;
    EXPECT_EQ(streamRateText(off.stream), "on change");
}

TEST_F(StreamTableTest, SettingsAreInWordsAndTellWhoseTheyAre) {
    EXPECT_EQ(requestText({}), "");
    EXPECT_EQ(requestText({.enabled = false, .rate = 4.0}), "off");
    EXPECT_EQ(requestText({true, 5.0, 40, 320}), "5 Hz, quality 40, 320 px");
    EXPECT_EQ(requestText({.rate = 2.5}), "2.5 Hz");
    StreamRow one = row();
    one.own = one.effective = {.rate = 12.0};
    EXPECT_EQ(settingText(one), "12 Hz");
    one.effective.rate = 5.0;
    EXPECT_EQ(settingText(one), "thin: 5 Hz · not yet");
    one.stream.rate = 5.0;
    EXPECT_EQ(settingText(one), "thin: 5 Hz");
}

TEST_F(StreamTableTest, OnlyWhatIsWrongIsLoud) {
    StreamRow one = row();
    EXPECT_EQ(toneOf(one), Tone::Normal);
    one.stream.lossRatio = 0.05;
    EXPECT_EQ(toneOf(one), Tone::Attention);
    table.setRows({one});
    EXPECT_EQ(table.data(table.index(0, StreamTable::Loss), ToneRole).toInt(), int(Tone::Attention));
    EXPECT_EQ(table.data(table.index(0, StreamTable::Name), ToneRole).toInt(), int(Tone::Normal));
}

TEST_F(StreamTableTest, NewFiguresKeepTheRowsAndOtherStreamsDoNot) {
    table.setRows({row(), row("/kurt3d/right")});
    QSignalSpy reset(&table, &QAbstractItemModel::modelReset),
        changed(&table, &QAbstractItemModel::dataChanged);
    table.setRows({row(), row("/kurt3d/right")});
    EXPECT_EQ(reset.count(), 0);
    EXPECT_EQ(changed.count(), 1);
    table.setRows({row()});
    EXPECT_EQ(reset.count(), 1);
    EXPECT_EQ(table.row(1), nullptr);
}

TEST_F(StreamTableTest, TheTotalNamesTheBudgetOfAThinLink) {
    EXPECT_EQ(linkTotalText(5.61, false, 2.0), "5.6 Mbit/s");
    EXPECT_EQ(linkTotalText(1.8, true, 2.0), "1.8 of 2.0 Mbit/s");
}

}  // namespace
}  // namespace leitstand
