#include "widgets/models/live/robots/robot_row.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/widgets/live/sample_robot.h"

namespace leitstand {
namespace {

using test::at;
using test::sampleRobot;
using test::SampleRobot;
using test::setStop;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RobotRows, HaveAllRobotsWhereThereIsRoom) {
    for (const int capacity : {3, 9}) {
        const RobotRow row = robotRowOf(3, capacity, 0, 1);
        EXPECT_THAT(row.shown, ElementsAre(0, 1, 2));
        EXPECT_THAT(row.before, IsEmpty());
        EXPECT_THAT(row.after, IsEmpty());
    }
    EXPECT_THAT(robotRowOf(0, 3, 0, -1).shown, IsEmpty());
}

TEST(RobotRows, KeepTheSelectedRobotInSightWhereverTheyAreScrolled) {
    const RobotRow before = robotRowOf(8, 3, 4, 1);
    EXPECT_THAT(before.shown, ElementsAre(1, 5, 6));
    EXPECT_THAT(before.before, ElementsAre(0, 2, 3, 4));
    EXPECT_THAT(before.after, ElementsAre(7));
    const RobotRow after = robotRowOf(8, 3, 0, 6);
    EXPECT_THAT(after.shown, ElementsAre(0, 1, 6));
    EXPECT_THAT(after.before, IsEmpty());
    EXPECT_THAT(after.after, ElementsAre(2, 3, 4, 5, 7));
}

TEST(RobotRows, ShowEachRobotSomewhereAndEachExactlyOnce) {
    for (const int capacity : {1, 2, 3, 5, 8}) {
        for (int selected = -1; selected < 8; ++selected) {
            std::set<int> seen;
            for (int first = -2; first < 12; ++first) {
                const RobotRow row = robotRowOf(8, capacity, first, selected);
                EXPECT_EQ(row.shown.size(), static_cast<std::size_t>(capacity));
                EXPECT_EQ(row.shown.size() + row.before.size() + row.after.size(), 8U);
                if (selected >= 0) {
                    EXPECT_THAT(row.shown, testing::Contains(selected));
                }
                seen.insert(row.shown.begin(), row.shown.end());
            }
            if (capacity > 1 || selected < 0) {
                EXPECT_EQ(seen.size(), 8U) << capacity << ' ' << selected;
            }
        }
    }
}

TEST(RobotRows, AreScrolledNoFartherThanNeeded) {
    EXPECT_EQ(firstToReveal(4, 3, 3), 3) << "it is in sight";
    EXPECT_EQ(firstToReveal(7, 3, 3), 5);
    EXPECT_EQ(firstToReveal(1, 3, 3), 1);
}

class HiddenRobotsTest : public testing::Test {
protected:
    void add(const SampleRobot& robot) {
        chips.push_back(robotChipOf(robot.face, robot.view, robot.reported, at(0)));
        stops.push_back(stopLineOf(robot.face, robot.view));
    }
    std::vector<RobotChip> chips;
    std::vector<StopLine> stops;
};

TEST_F(HiddenRobotsTest, TellTheWorstOfTheirLinksAndStops) {
    SampleRobot calm = sampleRobot("K", "Kurt3D", 0), standing = sampleRobot("C", "Crawler", 1),
                moving = sampleRobot("D", "Dozer", 2), silent = sampleRobot("E", "Eagle", 3);
    setStop(standing, true, true);
    setStop(moving, true, false);
    setStop(silent, false, false);
    silent.view.stop.unanswered = std::chrono::milliseconds(4200);
    moving.view.link.state = LinkState::Degraded;
    silent.view.link.state = LinkState::Lost;
    for (const SampleRobot* robot : {&calm, &standing, &moving, &silent}) add(*robot);

    HiddenRobots hidden = hiddenRobotsOf({0}, chips, stops);
    EXPECT_EQ(hidden.count, 1);
    EXPECT_EQ(hidden.link, LinkState::Connected);
    EXPECT_EQ(hidden.stop.stage, StopStage::None);
    hidden = hiddenRobotsOf({0, 1}, chips, stops);
    EXPECT_EQ(hidden.stop.stage, StopStage::Standing) << "one that is stopped is never hidden without a sign";
    EXPECT_EQ(hidden.stop.face.letter, "C");
    hidden = hiddenRobotsOf({2, 1, 0}, chips, stops);
    EXPECT_EQ(hidden.stop.stage, StopStage::Acknowledged) << "one that moves comes first";
    EXPECT_EQ(hidden.stop.face.letter, "D");
    EXPECT_EQ(hidden.link, LinkState::Degraded);
    hidden = hiddenRobotsOf({0, 1, 2, 3}, chips, stops);
    EXPECT_EQ(hidden.stop.tone, Tone::Act) << "nobody answers";
    EXPECT_EQ(hidden.stop.face.letter, "E");
    EXPECT_EQ(hidden.link, LinkState::Lost);
    for (const char* reported : {"Kurt3D (K)", "Crawler (C)", "Dozer (D)", "Eagle (E)", "STOP: standing",
                                 "STOP: confirmed · moves", "STOP: sent · no answer for 4.2 s"})
        EXPECT_THAT(hidden.details.toStdString(), HasSubstr(reported));
    EXPECT_EQ(hiddenRobotsOf({}, chips, stops), HiddenRobots{});
    EXPECT_EQ(hiddenRobotsOf({1}, chips, {}).stop.stage, StopStage::None) << "a review has no stops";
}

TEST(StopBriefs, AreAllThatAStopIsCalledWhereThereIsLittleRoom) {
    SampleRobot robot = sampleRobot();
    const QStringList all = stopBriefs();
    const auto brief = [&] { return stopLineOf(robot.face, robot.view).brief; };
    EXPECT_EQ(brief(), "");
    setStop(robot, false, false);
    EXPECT_TRUE(all.contains(brief())) << brief().toStdString();
    robot.view.stop.unanswered = std::chrono::milliseconds(4200);
    EXPECT_EQ(brief().toStdString(), "? 4.2 s");
    robot.view.stop.unanswered = std::chrono::seconds(100);
    EXPECT_EQ(brief().toStdString(), "? 1:40");
    robot.view.stop.unanswered = std::chrono::hours(20);
    EXPECT_TRUE(all.contains(brief())) << brief().toStdString();
    setStop(robot, true, false);
    EXPECT_TRUE(all.contains(brief())) << brief().toStdString();
    robot.view.stop.standingKnown = false;
    EXPECT_TRUE(all.contains(brief())) << brief().toStdString();
    setStop(robot, true, true);
    EXPECT_TRUE(all.contains(brief())) << brief().toStdString();
    robot.view.stop.releasing = true;
    EXPECT_TRUE(all.contains(brief())) << brief().toStdString();
    robot.view.stop = {};
    robot.view.stop.supported = false;
    robot.view.stop.sent = true;
    EXPECT_TRUE(all.contains(brief())) << brief().toStdString();
}

}  // namespace
}  // namespace leitstand
