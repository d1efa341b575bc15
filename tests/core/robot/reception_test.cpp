#include "core/robot/link/reception.h"

#include <gmock/gmock.h>

#include "core/event/stream_role.h"

namespace leitstand::test {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;

RobotDescription kurt3d() {
    RobotDescription robot;
    robot.name = "kurt3d";
    for (const auto& [role, topic] :
         {std::pair(StreamRole::Odometry, "/kurt3d/odom"), std::pair(StreamRole::Points, "/kurt3d/points"),
          std::pair(StreamRole::Transforms, "/tf"), std::pair(StreamRole::Battery, "/kurt3d/battery_state"),
          std::pair(StreamRole::Mode, "/kurt3d/mode"),
          std::pair(StreamRole::DriveCommand, "/kurt3d/cmd_vel")}) {
        StreamDescription stream;
        stream.role = role;
        stream.topic = topic;
        robot.streams.push_back(stream);
    }
    return robot;
}

AnnouncedWriter writer(const char* topic, double since, bool received = false, const char* process = "P") {
    return {topic, process, since, received};
}

TEST(Reception, TopicsThatAreAnnouncedAndDoNotComeAreAFaultAfterTwoSeconds) {
    Announced announced;
    announced.writers = {writer("/kurt3d/points", 1.9), writer("/kurt3d/odom", 1.9)};
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::NeverSeen, announced));
    for (AnnouncedWriter& one : announced.writers) one.seconds = 2.0;
    const auto fault = receptionFaultOf(kurt3d(), LinkState::NeverSeen, announced);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, ReceptionFault::Kind::Silent);
    EXPECT_THAT(fault->names, ElementsAre("/kurt3d/odom", "/kurt3d/points"));
    EXPECT_EQ(worded(*fault), "announced, but nothing comes: /kurt3d/odom, /kurt3d/points");
}

TEST(Reception, ARobotOfWhichAllIsHeardHasNone) {
    Announced announced;
    announced.writers = {writer("/kurt3d/odom", 9.0, true), writer("/kurt3d/points", 9.0, true)};
    for (const LinkState link : {LinkState::Connected, LinkState::Degraded})
        EXPECT_FALSE(receptionFaultOf(kurt3d(), link, announced));
    EXPECT_TRUE(isReceived(kurt3d(), announced));
}

TEST(Reception, ARobotThatOnlyAnswersPingsIsNotHeard) {
    Announced announced;
    announced.writers = {writer("/kurt3d/odom", 1.9), writer("/kurt3d/points", 1.9),
                         writer("/kurt3d/mode", 9.0, true), writer("/kurt3d/battery_state", 9.0, true)};
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::Connected, announced));
    announced.writers[1].seconds = 2.0;
    const auto fault = receptionFaultOf(kurt3d(), LinkState::Connected, announced);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, ReceptionFault::Kind::Silent);
    EXPECT_THAT(fault->names, ElementsAre("/kurt3d/odom", "/kurt3d/points"));
    EXPECT_FALSE(isReceived(kurt3d(), announced));
}

TEST(Reception, ATopicThatNeverCameWhileOthersDoIsAFaultAfterFiveSeconds) {
    Announced announced;
    announced.writers = {writer("/kurt3d/odom", 4.9), writer("/kurt3d/points", 9.0, true)};
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::Connected, announced))
        << "sensors take a while to start";
    announced.writers[0].seconds = 5.0;
    const auto fault = receptionFaultOf(kurt3d(), LinkState::Degraded, announced);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, ReceptionFault::Kind::Partial);
    EXPECT_EQ(worded(*fault), "announced, but never came: /kurt3d/odom");
    EXPECT_FALSE(isOver(*fault, LinkState::Connected, announced));
    announced.writers = {writer("/kurt3d/odom", 9.0, true), writer("/kurt3d/points", 9.0)};
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::Connected, announced))
        << "a scanner may be switched off";
    announced.writers = {writer("/kurt3d/odom", 9.0), writer("/kurt3d/points", 9.0, true)};
    announced.writers.push_back(writer("/kurt3d/odom", 1.0, true, "another node"));
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::Degraded, announced))
        << "one of its writers is enough";
    EXPECT_TRUE(isOver(*fault, LinkState::Connected, announced));
}

TEST(Reception, StreamsOnEventsSlowOnesAndThoseOfAllRobotsSayNothing) {
    Announced announced;
    announced.writers = {writer("/kurt3d/mode", 9.0), writer("/kurt3d/battery_state", 9.0),
                         writer("/tf", 9.0), writer("/crawler/odom", 9.0)};
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::NeverSeen, announced));
}

TEST(Reception, ALinkThatWasLostIsNoFaultButOneThatCameBackMuteIs) {
    Announced announced;
    announced.writers = {writer("/kurt3d/odom", 90.0, true, "before")};
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::Lost, announced)) << "a gap of the radio";
    announced.writers.push_back(writer("/kurt3d/odom", 3.0, false, "started again"));
    EXPECT_TRUE(receptionFaultOf(kurt3d(), LinkState::Lost, announced));
}

TEST(Reception, AProcessWithoutTopicsIsAFaultWhileNothingElseOfTheRobotIsThere) {
    Announced announced;
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::NeverSeen, announced)) << "it is not there";
    announced.mute = {{"kurt3d", 1.0}};
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::NeverSeen, announced));
    announced.mute = {{"kurt3d", 2.5}};
    const auto fault = receptionFaultOf(kurt3d(), LinkState::NeverSeen, announced);
    ASSERT_TRUE(fault);
    EXPECT_EQ(worded(*fault), "announced by kurt3d, but none of its topics are");
    EXPECT_FALSE(receptionFaultOf(kurt3d(), LinkState::Connected, announced));
}

TEST(Reception, ListsOfManyTopicsAreCut) {
    const ReceptionFault fault{ReceptionFault::Kind::Silent, {"/a", "/b", "/c", "/d", "/e"}};
    EXPECT_EQ(worded(fault), "announced, but nothing comes: /a, /b, /c, /d, ...");
}

const ReceptionFault Silent{ReceptionFault::Kind::Silent, {"/kurt3d/odom"}, 2.0};

ReceptionFault partial(const char* topic, double announced) {
    return {ReceptionFault::Kind::Partial, {topic}, announced};
}

TEST(RejoinPlan, ThreeTimesThenNotUntilTheRobotWasHeard) {
    RejoinPlan plan;
    const SteadyTime begin{};
    EXPECT_FALSE(plan.isDue({}, true, begin));
    EXPECT_TRUE(plan.isDue(Silent, true, begin));
    EXPECT_FALSE(plan.isDue(Silent, true, begin + seconds(4)));
    EXPECT_FALSE(plan.isDue({}, true, begin + seconds(4))) << "all is new for two seconds after joining";
    EXPECT_TRUE(plan.isDue(Silent, true, begin + seconds(5)));
    EXPECT_FALSE(plan.isDue(Silent, true, begin + seconds(19)));
    EXPECT_FALSE(plan.hasFailed(Silent, begin + seconds(19)));
    EXPECT_TRUE(plan.isDue(Silent, true, begin + seconds(20)));
    EXPECT_FALSE(plan.hasFailed(Silent, begin + seconds(24))) << "the third time may have helped";
    EXPECT_TRUE(plan.hasFailed(Silent, begin + seconds(25)));
    EXPECT_FALSE(plan.hasFailed(Silent, begin + seconds(26))) << "said once";
    EXPECT_FALSE(plan.isDue(Silent, true, begin + seconds(1000)));
    plan.received();
    EXPECT_TRUE(plan.isDue(Silent, true, begin + seconds(1001)));
}

TEST(RejoinPlan, NotWhileARobotMovesOrIsBeingStopped) {
    RejoinPlan plan;
    const SteadyTime begin{};
    EXPECT_FALSE(plan.isDue(Silent, false, begin));
    EXPECT_FALSE(plan.isDue(Silent, false, begin + seconds(100)));
    EXPECT_TRUE(plan.isDue(Silent, true, begin + seconds(101)));
}

TEST(RejoinPlan, OnceForATopicAndOnlySoonAfterItWasDiscovered) {
    RejoinPlan plan;
    const SteadyTime now{};
    EXPECT_FALSE(plan.isDue(partial("/kurt3d/scan", 5.0), false, now)) << "a robot moves";
    EXPECT_TRUE(plan.isDue(partial("/kurt3d/scan", 6.0), true, now));
    plan.received();
    EXPECT_FALSE(plan.isDue(partial("/kurt3d/scan", 5.0), true, now + seconds(10)));
    EXPECT_TRUE(plan.hasFailed(partial("/kurt3d/scan", 5.0), now + seconds(10)));
    EXPECT_FALSE(plan.hasFailed(partial("/kurt3d/scan", 6.0), now + seconds(11))) << "said once";
    EXPECT_FALSE(plan.isDue(partial("/kurt3d/imu", 25.0), true, now)) << "it may well be switched off";
    EXPECT_TRUE(plan.hasFailed(partial("/kurt3d/imu", 25.0), now));
    EXPECT_TRUE(plan.isDue(partial("/kurt3d/odom", 5.0), true, now + seconds(100)));
}

}  // namespace
}  // namespace leitstand::test
