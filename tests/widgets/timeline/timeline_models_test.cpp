#include <chrono>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QLocale>

#include "widgets/models/timeline/timeline_axis.h"
#include "widgets/models/timeline/timeline_text.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;
using testing::SizeIs;

Time at(double seconds) {
    return Time(1'750'000'000s) + std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

TEST(TimelineAxis, GapsAreShortHoweverLongTheyWere) {
    const TimelineAxis axis({{at(0), at(60)}, {at(100'000), at(100'040)}});
    EXPECT_EQ(axis.placeOf(at(0)), 0.0);
    EXPECT_NEAR(axis.placeOf(at(100'040)), 1.0, 1e-12);
    ASSERT_THAT(axis.gaps(), SizeIs(1));
    const auto [from, to] = axis.gaps().front();
    EXPECT_NEAR(from, 60.0 / 102.0, 1e-9);
    EXPECT_NEAR(to, 62.0 / 102.0, 1e-9);
    EXPECT_NEAR(axis.placeOf(at(5'000)), 61.0 / 102.0, 1e-9) << "in the middle of the gap";
    EXPECT_EQ(axis.recordedUntil(at(100'010)), 70s);
    EXPECT_EQ(axis.recordedUntil(at(5'000)), 60s);
    EXPECT_EQ(axis.recordedUntil(at(-5)), 0s);
}

TEST(TimelineAxis, PlacesAndTimesAreInverse) {
    const TimelineAxis axis({{at(0), at(60)}, {at(500), at(540)}, {at(900), at(1000)}});
    for (const double seconds : {0.0, 12.5, 60.0, 500.0, 533.0, 540.0, 900.0, 999.0, 1000.0}) {
        const auto error = axis.timeAt(axis.placeOf(at(seconds))) - at(seconds);
        EXPECT_LT(std::abs(std::chrono::duration<double>(error).count()), 1e-5) << seconds;
    }
    EXPECT_EQ(axis.timeAt(-3.0), at(0));
    EXPECT_EQ(axis.timeAt(7.0), at(1000));
    const auto [from, to] = axis.gaps().front();
    EXPECT_EQ(axis.timeAt(from + 0.1 * (to - from)), at(60)) << "a gap is its nearer end";
    EXPECT_EQ(axis.timeAt(from + 0.9 * (to - from)), at(500));
}

TEST(TimelineAxis, HoldsWithoutTime) {
    const TimelineAxis nothing;
    EXPECT_TRUE(nothing.empty());
    EXPECT_EQ(nothing.placeOf(at(3)), 0.0);
    EXPECT_THAT(nothing.ticks(0.1), IsEmpty());
    const TimelineAxis moment({TimelineStretch{at(5), at(5)}});
    EXPECT_EQ(moment.placeOf(at(5)), 0.0);
    EXPECT_EQ(moment.timeAt(0.7), at(5));
}

TEST(TimelineAxis, TicksStandAtRoundTimesApartFromAnother) {
    const TimelineAxis axis({TimelineStretch{at(3), at(1203)}});
    const auto ticks = axis.ticks(0.1);
    ASSERT_GE(ticks.size(), 4U);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        EXPECT_EQ(ticks[i].at.time_since_epoch() % 2min, 0s);
        EXPECT_NEAR(ticks[i].place, axis.placeOf(ticks[i].at), 1e-12);
        if (i > 0) {
            EXPECT_GE(ticks[i].place - ticks[i - 1].place, 0.09);
        }
    }
}

TEST(TimelineWords, EveryKindOfMarkHasItsShapeAndSaysItself) {
    using Kind = TimelineMark::Kind;
    const std::vector<RobotFace> faces = [] {
        RobotFace kurt;
        kurt.name = QStringLiteral("kurt3d");
        kurt.letter = QStringLiteral("K");
        return std::vector{kurt};
    }();
    const std::vector<TimelineMark> marks = {
        {.kind = Kind::Session, .at = at(0), .key = "start", .text = "Desk"},
        {.kind = Kind::Mode, .at = at(1), .robot = "kurt3d", .key = "explore"},
        {.kind = Kind::Victim, .at = at(2), .robot = "kurt3d", .key = "confirmed", .name = "V12"},
        {.kind = Kind::Alarm,
         .at = at(3),
         .robot = "kurt3d",
         .key = "link_lost",
         .text = "link lost",
         .act = true},
        {.kind = Kind::Note, .at = at(4), .text = "door"},
        {.kind = Kind::Decision, .at = at(5), .key = "undo", .text = "scan 4 rejected"},
        {.kind = Kind::Bump, .at = at(6), .robot = "kurt3d", .key = "front_left", .act = true},
        {.kind = Kind::Sighting, .at = at(7), .robot = "else", .key = "code", .text = "exit"},
        {.kind = Kind::Candidate,
         .at = at(8),
         .robot = "kurt3d",
         .key = "told",
         .name = "victim",
         .text = "heat, motion",
         .candidate = 3,
         .confidence = 0.72},
        {.kind = Kind::Moved,
         .at = at(9),
         .key = "loop closure",
         .name = "V1",
         .from = {1.0, 0.0, 0.0},
         .to = {1.0, 0.3, 0.0}},
    };
    const TimelineAxis axis({TimelineStretch{at(0), at(10)}});
    const auto glyphs = glyphsOf(marks, axis, faces);
    ASSERT_THAT(glyphs, SizeIs(marks.size()));
    std::set<MarkShape> shapes;
    for (const TimelineGlyph& glyph : glyphs) shapes.insert(glyph.shape);
    EXPECT_EQ(shapes.size(), marks.size()) << "no two kinds alike";
    EXPECT_EQ(glyphs[2].letter, "12");
    EXPECT_NEAR(glyphs[2].place, 0.2, 1e-9);
    EXPECT_EQ(glyphs[3].tone, Tone::Act);
    EXPECT_EQ(markText(marks[0], faces), "recording began (Desk)");
    EXPECT_EQ(markText(marks[1], faces), "K · mode: explore");
    EXPECT_EQ(markText(marks[2], faces), "K · V12 confirmed");
    EXPECT_EQ(markText(marks[3], faces), "K · alarm: link lost");
    TimelineMark alarm = marks[3];
    alarm.text = "Kurt3D: link lost, silent for 4 s";
    EXPECT_EQ(markText(alarm, faces), "K · alarm: link lost, silent for 4 s") << "named once";
    alarm.key = "gas";
    alarm.text = "Kurt3D: CO2 845 ppm";
    EXPECT_EQ(markText(alarm, faces).toStdString(), "K · alarm: CO₂ 845 ppm") << "by its key";
    alarm = {
        .kind = Kind::Alarm, .key = "disk_full", .text = "/a.db3: the disk is full; 512 MB wait in memory"};
    EXPECT_EQ(markText(alarm, faces), "alarm: log: the disk is full; 512 MB wait in memory");
    alarm.text.clear();
    EXPECT_EQ(markText(alarm, faces), "alarm: log: disk full");
    EXPECT_EQ(markText(marks[4], faces), "note: door");
    EXPECT_EQ(markText(marks[5], faces), "undone: scan 4 rejected");
    EXPECT_EQ(markText(marks[6], faces), "K · bumped: front left");
    EXPECT_EQ(markText(marks[7], faces), "else · the robot saw a code: exit");
    EXPECT_EQ(markText(marks[8], faces).toStdString(), "K · candidate: a victim, 72\u202f% (heat, motion)");
    EXPECT_EQ(glyphs[8].letter, "?");
    EXPECT_EQ(markText(marks[9], faces).toStdString(),
              "V1 moved 0.30 m, since a loop was closed (1.00  0.00  0.00 → 1.00  0.30  0.00)");
    EXPECT_EQ(glyphs[9].tone, Tone::Muted) << "nobody did it";
    TimelineMark dismissed = marks[8];
    dismissed.key = "dismissed";
    EXPECT_EQ(markText(dismissed, faces), "K · candidate dismissed: a victim");
    EXPECT_EQ(glyphsOf({dismissed}, axis, faces).front().tone, Tone::Muted);
    TimelineMark code = marks[8];
    code.name = "code", code.text = "A, B";
    EXPECT_EQ(markText(code, faces).toStdString(), "K · candidate: a code, 72\u202f% (A, B)");
}

TEST(TimelineWords, WhatWasUndoneIsToldByItsKind) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    const auto text = [](const char* key, const char* logged) {
        return markText({.kind = TimelineMark::Kind::Decision, .key = key, .text = logged}, {}).toStdString();
    };
    EXPECT_EQ(text("undo", "undo: scan 1234 taken"), "undone: scan 1234 accepted");
    EXPECT_EQ(text("undo", "undo: 1234 scans set aside"), "undone: 1,234 scans set aside");
    EXPECT_EQ(text("redo", "redo: 3 scans tried"), "done again: 3 scans tried again");
    EXPECT_EQ(text("redo", "redo: what belongs into the map"), "done again: what belongs into the map");
    EXPECT_EQ(text("undo", "undo: V1"), "undone: V1");
    EXPECT_EQ(text("undo", "H2 as corrected in a review"), "undone: H2 as corrected in a review");
    EXPECT_EQ(text("undo", "a note of a review"), "undone: a note of a review");
    EXPECT_EQ(text("undo", ""), "undone");
    EXPECT_EQ(text("redo", ""), "done again");
    EXPECT_EQ(text("undo", "undo: scan %1 taken"), "undone: undo: scan %1 taken") << "as it was logged";
    EXPECT_EQ(text("redo", "the door"), "done again: the door");
    EXPECT_EQ(text("poses", ""), "decision on scans");
}

TEST(TimelineWords, FiguresAreOfTheLanguage) {
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    const TimelineMark moved = {.kind = TimelineMark::Kind::Moved,
                                .key = "undo",
                                .name = "V1",
                                .from = {1.0, -0.5, 0.0},
                                .to = {1.0, -0.25, 0.0}};
    EXPECT_EQ(markText(moved, {}).toStdString(),
              "V1 moved 0,25 m, since a decision was taken back (1,00  −0,50  0,00 → 1,00  −0,25  0,00)");
    const TimelineMark undone = {
        .kind = TimelineMark::Kind::Decision, .key = "undo", .text = "undo: 1234 scans taken"};
    EXPECT_EQ(markText(undone, {}).toStdString(), "undone: 1.234 scans accepted");
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
}

TEST(TimelineWords, RatesGoThroughTheirStepsInBothDirections) {
    EXPECT_EQ(nextRate(1.0, true), 2.0);
    EXPECT_EQ(nextRate(0.0, true), 2.0);
    EXPECT_EQ(nextRate(0.0, false), 0.5);
    EXPECT_EQ(nextRate(0.1, false), 0.1);
    EXPECT_EQ(nextRate(32.0, true), 32.0);
    EXPECT_EQ(nextRate(-1.0, true), -2.0);
    EXPECT_EQ(nextRate(3.0, false), 2.0);
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    EXPECT_EQ(rateText(0.0), "stands");
    EXPECT_EQ(rateText(4.0), "4×");
    EXPECT_EQ(rateText(0.25), "0.25×");
    EXPECT_EQ(rateText(-0.5), "backwards 0.5×");
}

TEST(TimelineWords, RecordedTimeIsReadAsMinutes) {
    EXPECT_EQ(recordedText(0s), "0:00.0");
    EXPECT_EQ(recordedText(271'540ms), "4:31.5");
    EXPECT_EQ(recordedText(3'871s), "1:04:31.0");
    EXPECT_EQ(recordedText(-5s), "0:00.0");
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(recordedText(271'540ms), "4:31,5");
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
}

TEST(TimelineMarks, NextAndPreviousAreThoseBesideTheMoment) {
    const std::vector<TimelineMark> marks = {{.at = at(1)}, {.at = at(4)}, {.at = at(4)}, {.at = at(9)}};
    EXPECT_EQ(markAfter(marks, at(1))->at, at(4));
    EXPECT_EQ(markAfter(marks, at(4))->at, at(9));
    EXPECT_EQ(markAfter(marks, at(9)), nullptr);
    EXPECT_EQ(markBefore(marks, at(4))->at, at(1));
    EXPECT_EQ(markBefore(marks, at(1)), nullptr);
    EXPECT_EQ(markBefore(marks, at(100))->at, at(9));
}

}  // namespace
}  // namespace leitstand
