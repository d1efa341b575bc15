#include "widgets/models/map/robots/robot_marks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using testing::HasSubstr;

const RobotFace Kurt{QStringLiteral("kurt3d"), QStringLiteral("K"), QStringLiteral("Kurt3D"), 0};

RobotDescription tracked() {
    RobotDescription robot;
    robot.drive = DriveType::Tracked;
    robot.footprint = {{0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.2, -0.1}};
    robot.height = 0.35;
    return robot;
}

RobotInMap placed(bool certain, double certainty) {
    RobotInMap place;
    place.placed = true;
    place.certain = certain;
    place.certainty = certainty;
    place.baseInMap = poseFrom({1, 2, 0}, 0, 0, degrees(30));
    return place;
}

LinkStatus linked(LinkState state) {
    LinkStatus link;
    link.state = state;
    return link;
}

TEST(RobotMarks, StandWhereTheRobotIs) {
    const auto mark = robotMarkOf(Kurt, tracked(), placed(true, 0.9), linked(LinkState::Connected), true);
    ASSERT_TRUE(mark);
    EXPECT_NEAR(headingOf(mark->baseInMap), degrees(30), 1e-9);
    EXPECT_TRUE(mark->tracked);
    EXPECT_TRUE(mark->selected);
    EXPECT_FALSE(mark->doubtRadius);
    EXPECT_TRUE(mark->note.isEmpty());
}

TEST(RobotMarks, AreNotThereWhileNobodyKnowsWhere) {
    EXPECT_FALSE(robotMarkOf(Kurt, tracked(), RobotInMap{}, linked(LinkState::Connected), true));
}

TEST(RobotMarks, DoubtIsARingThatGrows) {
    const auto some = robotMarkOf(Kurt, tracked(), placed(false, 0.8), linked(LinkState::Connected), false);
    const auto much = robotMarkOf(Kurt, tracked(), placed(false, 0.1), linked(LinkState::Connected), false);
    ASSERT_TRUE(some && some->doubtRadius && much && much->doubtRadius);
    EXPECT_LT(*some->doubtRadius, *much->doubtRadius);
    EXPECT_EQ(some->tone, Tone::Attention);
    EXPECT_THAT(some->note.toStdString(), HasSubstr("uncertain"));
}

TEST(RobotMarks, TellHowSureThePlaceIsAndWhy) {
    const auto details = [](RobotInMap place, const char* how, LinkState link = LinkState::Connected) {
        place.how = how;
        QString text = robotMarkOf(Kurt, tracked(), place, linked(link), false)->details;
        return text.replace(QChar(0x202F), QLatin1Char(' ')).toStdString();
    };
    EXPECT_EQ(details(placed(true, 0.834), "its scan fits the map"),
              "Kurt3D: place certain to 83 %: its scan fits the map");
    EXPECT_EQ(details(placed(false, 0.12), "its laser fits 9 cm from where its tracks say"),
              "Kurt3D: place uncertain, 12 %: its laser fits 9 cm from where its tracks say");
    EXPECT_EQ(details(placed(false, 0.0), "little overlap with the map, a jump against the odometry"),
              "Kurt3D: place uncertain, 0 %: little overlap, jump")
        << "in the words of the list of scans";
    EXPECT_EQ(details(placed(true, 1.0), ""), "Kurt3D: place certain to 100 %");
    EXPECT_THAT(details(placed(true, 1.0), "", LinkState::Lost), HasSubstr("seen here last"));
    const auto mark = *robotMarkOf(Kurt, tracked(), placed(true, 1.0), linked(LinkState::Connected), false);
    EXPECT_EQ(detailsOf({mark, mark}), mark.details + QLatin1Char('\n') + mark.details);
}

TEST(RobotMarks, ALostOneWasSeenThereLast) {
    const auto mark = robotMarkOf(Kurt, tracked(), placed(true, 1.0), linked(LinkState::Lost), false);
    ASSERT_TRUE(mark);
    EXPECT_TRUE(mark->stale);
    EXPECT_THAT(mark->note.toStdString(), HasSubstr("last"));
}

TEST(RobotMarks, AreTheSameUntilSomethingIsDrawnOtherwise) {
    const auto mark = *robotMarkOf(Kurt, tracked(), placed(true, 1.0), linked(LinkState::Connected), false);
    RobotMark other = mark;
    EXPECT_TRUE(sameMark(mark, other));
    other.goalInMap = Pose::Identity();
    EXPECT_FALSE(sameMark(mark, other));
    EXPECT_TRUE(sameMark(other, other));
    other = mark;
    other.baseInMap.translation().x() += 0.001;
    EXPECT_FALSE(sameMark(mark, other));
}

TEST(RobotMarks, WhoIsMissingIsSaid) {
    EXPECT_EQ(unplacedText({}, QStringLiteral("Shift+O")), "");
    EXPECT_THAT(unplacedText({Kurt}, QStringLiteral("Shift+O")).toStdString(), HasSubstr("Kurt3D"));
    EXPECT_THAT(unplacedText({Kurt}, QStringLiteral("Shift+O")).toStdString(), HasSubstr("Shift+O"));
}

}  // namespace
}  // namespace leitstand::test
