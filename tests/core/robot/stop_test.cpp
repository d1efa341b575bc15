#include <limits>

#include <gmock/gmock.h>

#include "core/robot/control/stop/stop_control.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

StopCommandSample stopOf(const std::string& station, std::uint64_t number) {
    return {{}, station, number, true, 0};
}
StopCommandSample releaseOf(const std::string& station, std::uint64_t number, std::uint64_t stops) {
    return {{}, station, number, false, stops};
}

TEST(StopLatch, AStopOfAnybodyStaysUntilTheHolderReleasesIt) {
    StopLatch latch(100);
    EXPECT_FALSE(latch.isStopped());
    const StopStateSample stopped = latch.receive(stopOf("viewer", 7), sender(1), false);
    EXPECT_TRUE(stopped.stopped);
    EXPECT_EQ(stopped.number, 7U);
    EXPECT_EQ(stopped.station, "viewer");
    EXPECT_EQ(stopped.stops, 101U);
    const StopStateSample refused = latch.receive(releaseOf("viewer", 8, 101), sender(1), false);
    EXPECT_TRUE(refused.stopped);
    EXPECT_EQ(refused.number, 8U);
    EXPECT_THAT(refused.refused, HasSubstr("holds the drive grant"));
    const StopStateSample released = latch.receive(releaseOf("a", 3, 101), sender(2), true);
    EXPECT_FALSE(released.stopped) << released.refused;
    EXPECT_EQ(released.refused, "");
}

TEST(StopLatch, ARepeatedCommandIsAnsweredButCountsOnce) {
    StopLatch latch;
    static_cast<void>(latch.receive(stopOf("a", 5), sender(1), true));
    const StopStateSample again = latch.receive(stopOf("a", 5), sender(1), true);
    EXPECT_EQ(again.number, 5U);
    EXPECT_EQ(again.stops, 1U);
    static_cast<void>(latch.receive(releaseOf("b", 1, 1), sender(2), true));
    const StopStateSample late = latch.receive(stopOf("a", 5), sender(1), true);
    EXPECT_FALSE(late.stopped) << "a repeated stop undoes no release";
    EXPECT_EQ(late.number, 5U) << "but is acknowledged";
    EXPECT_EQ(late.station, "a");
    EXPECT_TRUE(latch.receive(stopOf("a", 6), sender(1), true).stopped) << "a new one stops";
}

TEST(StopLatch, AReleaseThatWasGivenBeforeAnotherStopReleasesNothing) {
    StopLatch latch;
    static_cast<void>(latch.receive(stopOf("a", 5), sender(1), true));
    const StopCommandSample release = releaseOf("a", 1'000'000, 1);  // a's clock is far ahead of b's
    static_cast<void>(latch.receive(stopOf("b", 6), sender(2), false));
    const StopStateSample state = latch.receive(release, sender(1), true);
    EXPECT_TRUE(state.stopped);
    EXPECT_THAT(state.refused, HasSubstr("again"));
    EXPECT_FALSE(latch.receive(releaseOf("a", 1'000'001, 2), sender(1), true).stopped);
}

TEST(StopLatch, AReplayedReleaseReleasesNothing) {
    StopLatch latch;
    static_cast<void>(latch.receive(stopOf("a", 5), sender(1), true));
    const StopCommandSample release = releaseOf("a", 6, 1);
    EXPECT_FALSE(latch.receive(release, sender(1), true).stopped);
    static_cast<void>(latch.receive(stopOf("b", 6), sender(2), false));
    EXPECT_TRUE(latch.receive(release, sender(1), true).stopped);
    static_cast<void>(latch.receive(stopOf("a", 7), sender(1), true));
    EXPECT_TRUE(latch.receive(release, sender(1), true).stopped);
    EXPECT_TRUE(latch.receive(releaseOf("a", 6, 3), sender(1), true).stopped) << "its number is old";
}

TEST(StopLatch, AStopWithASmallerNumberStops) {
    StopLatch latch;
    static_cast<void>(latch.receive(stopOf("a", 1'000), sender(1), true));
    static_cast<void>(latch.receive(releaseOf("a", 1'001, 1), sender(1), true));
    ASSERT_FALSE(latch.isStopped());
    const StopStateSample restarted = latch.receive(stopOf("a", 3), sender(2), true);
    EXPECT_TRUE(restarted.stopped);
    EXPECT_EQ(restarted.number, 3U);
    static_cast<void>(latch.receive(releaseOf("a", 4, 2), sender(2), true));
    ASSERT_FALSE(latch.isStopped());
    EXPECT_TRUE(latch.receive(stopOf("a", 2), sender(2), true).stopped) << "even from the same process";
}

TEST(StopLatch, ItsOwnButtonStopsToo) {
    StopLatch latch;
    latch.press();
    EXPECT_TRUE(latch.isStopped());
    EXPECT_EQ(latch.state().station, "");
    EXPECT_FALSE(latch.receive(releaseOf("a", 1, 1), sender(1), true).stopped);
}

TEST(StopLatch, AnyNumberOfProcessesTakesBoundedRoomAndStillStops) {
    StopLatch latch;
    for (std::uint8_t i = 0; i < 250; ++i) {
        EXPECT_TRUE(latch.receive(stopOf(fmt::format("s{}", i), 1), sender(i), false).stopped);
    }
    EXPECT_EQ(latch.state().stops, 250U);
}

TEST(Standing, NeedsRestForAWhileAndOdometryThatIsFresh) {
    StandingJudge judge;
    EXPECT_FALSE(judge.isKnown(at(0)));
    judge.moved(0.3, 0.0, at(0));
    EXPECT_TRUE(judge.isKnown(at(0)));
    for (int now = 50; now <= 200; now += 50) judge.moved(0.001, 0.0, at(now));
    EXPECT_FALSE(judge.isStanding(at(200)));
    judge.moved(0.0, -0.01, at(250));
    EXPECT_TRUE(judge.isStanding(at(250)));
    judge.moved(0.0, -0.5, at(300));
    EXPECT_FALSE(judge.isStanding(at(300)));
    for (int now = 350; now <= 600; now += 50) judge.moved(0.0, 0.0, at(now));
    EXPECT_TRUE(judge.isStanding(at(600)));
    EXPECT_FALSE(judge.isStanding(at(1'600))) << "nothing was heard for a second";
    judge.moved(0.0, 0.0, at(1'700));
    EXPECT_FALSE(judge.isStanding(at(1'700))) << "who knows what was in between";
    judge.moved(std::numeric_limits<double>::quiet_NaN(), 0.0, at(1'900));
    judge.moved(0.0, 0.0, at(2'000));
    EXPECT_FALSE(judge.isStanding(at(2'000)));
}

class Control : public testing::Test {
protected:
    /// What is sent at @p now.
    std::optional<StopCommandSample> due(std::int64_t now) { return m_control.due(at(now), wallAt(now)); }
    void stop(std::int64_t now) { m_control.stop(at(now), wallAt(now)); }
    Result<void> release(std::int64_t now, bool held = true) {
        return m_control.release(held, at(now), wallAt(now));
    }
    /// The robot gets @p command and is heard.
    void answer(const std::optional<StopCommandSample>& command, bool held = true) {
        ASSERT_TRUE(command);
        m_control.receive(m_robot.receive(*command, sender(1), held));
    }
    StopControl m_control{"a"};
    StopLatch m_robot{1'000};
};

TEST_F(Control, RepeatsAStopUntilItIsAcknowledged) {
    EXPECT_TRUE(m_control.allowsDriving());
    EXPECT_FALSE(due(0));
    stop(0);
    EXPECT_FALSE(m_control.allowsDriving());
    const auto first = due(0);
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->stop);
    EXPECT_EQ(first->station, "a");
    int repeated = 0;
    for (std::int64_t now = 20; now <= 60'000; now += 20) {
        const auto again = due(now);
        if (!again) continue;
        ++repeated;
        EXPECT_EQ(again->number, first->number);
    }
    EXPECT_EQ(repeated, 600) << "ten times a second, for ever";
    EXPECT_TRUE(m_control.status(at(60'000)).sent);
    EXPECT_FALSE(m_control.status(at(60'000)).acknowledged);
    EXPECT_EQ(m_control.status(at(60'000)).unanswered, std::chrono::seconds(60));
    answer(first);
    EXPECT_TRUE(m_control.status(at(60'000)).acknowledged);
    EXPECT_TRUE(m_control.status(at(60'000)).stopped);
    EXPECT_EQ(m_control.status(at(60'000)).unanswered, std::chrono::seconds(0));
    EXPECT_FALSE(due(61'000));
}

TEST_F(Control, OnlyTheAnswerToItsOwnNumberCounts) {
    stop(0);
    const auto command = due(0);
    StopStateSample other = m_robot.receive(stopOf("b", command->number), sender(2), false);
    m_control.receive(other);
    EXPECT_FALSE(m_control.status(at(0)).acknowledged) << "of another station";
    EXPECT_TRUE(m_control.status(at(0)).stopped);
    other.station = "a";
    other.number = command->number - 1;
    m_control.receive(other);
    EXPECT_FALSE(m_control.status(at(0)).acknowledged) << "of an earlier one";
    EXPECT_TRUE(due(100));
}

TEST_F(Control, NumbersRiseEvenWhenTheClockIsSetBack) {
    std::uint64_t last = 0;
    for (const std::int64_t clock : {5'000, 4'000, -10'000'000, 6'000}) {
        m_control.stop(at(clock), wallAt(clock));
        const auto command = m_control.due(at(clock), wallAt(clock));
        ASSERT_TRUE(command);
        EXPECT_GT(command->number, last);
        last = command->number;
    }
    StopControl again("a");
    again.stop(at(0), wallAt(7'000));
    EXPECT_GT(again.due(at(0), wallAt(7'000))->number, last)
        << "a restarted station is above its earlier self";
    StopControl before("a");
    before.stop(at(0), Time(std::chrono::nanoseconds(-5)));
    EXPECT_GT(before.due(at(0), {})->number, 0U);
}

TEST_F(Control, ReleasesWhatTheRobotTold) {
    stop(0);
    EXPECT_THAT(release(10).error().text, HasSubstr("not reported"));
    answer(due(0));
    EXPECT_THAT(release(10, false).error().text, HasSubstr("grant"));
    ASSERT_TRUE(release(20).ok());
    EXPECT_TRUE(m_control.status(at(20)).releasing);
    EXPECT_FALSE(m_control.allowsDriving());
    const auto command = due(20);
    ASSERT_TRUE(command);
    EXPECT_EQ(command->releases, 1'001U);
    answer(command);
    EXPECT_FALSE(m_control.status(at(30)).sent);
    EXPECT_FALSE(m_control.status(at(30)).stopped);
    EXPECT_TRUE(m_control.allowsDriving());
    EXPECT_FALSE(due(1'000));
}

TEST_F(Control, NoReleaseBeforeTheStopIsAcknowledged) {
    stop(0);
    m_control.receive(m_robot.state());
    EXPECT_THAT(release(10).error().text, HasSubstr("acknowledged"));
}

TEST_F(Control, ARefusedReleaseSaysWhy) {
    stop(0);
    answer(due(0));
    ASSERT_TRUE(release(20).ok());
    answer(due(20), false);
    const StopStatus status = m_control.status(at(30));
    EXPECT_TRUE(status.sent);
    EXPECT_TRUE(status.stopped);
    EXPECT_FALSE(status.releasing);
    EXPECT_THAT(status.refused, HasSubstr("grant"));
    stop(40);
    EXPECT_EQ(m_control.status(at(40)).refused, "");
}

TEST_F(Control, AStopOfAnotherEndsARelease) {
    stop(0);
    answer(due(0));
    ASSERT_TRUE(release(20).ok());
    const auto underway = due(20);
    m_control.receive(m_robot.receive(stopOf("b", 9), sender(2), false));
    EXPECT_FALSE(m_control.status(at(30)).releasing);
    EXPECT_THAT(m_control.status(at(30)).refused, HasSubstr("again"));
    EXPECT_FALSE(due(200));
    answer(underway);
    EXPECT_TRUE(m_control.status(at(40)).stopped);
    EXPECT_FALSE(m_control.allowsDriving());
    ASSERT_TRUE(release(50).ok());
    answer(due(50));
    EXPECT_TRUE(m_control.allowsDriving());
}

TEST_F(Control, AReleaseThatIsNotAnsweredIsTakenBack) {
    stop(0);
    answer(due(0));
    ASSERT_TRUE(release(100).ok());
    const auto lost = due(100);
    ASSERT_TRUE(lost && !lost->stop);
    EXPECT_TRUE(due(2'050) && !due(2'060));
    const auto back = due(2'150);
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->stop);
    EXPECT_GT(back->number, lost->number);
    EXPECT_THAT(m_control.status(at(2'150)).refused, HasSubstr("did not answer"));
    answer(back);
    answer(lost);  // arrives after all
    EXPECT_TRUE(m_robot.isStopped());
}

TEST_F(Control, IsOverWhenTheHolderReleasedIt) {
    stop(0);
    answer(due(0));
    m_control.receive(m_robot.receive(releaseOf("b", 3, 1'001), sender(2), true));
    EXPECT_FALSE(m_control.status(at(0)).sent);
    EXPECT_TRUE(m_control.allowsDriving());
}

TEST_F(Control, AnUnacknowledgedStopStandsWhateverTheRobotSays) {
    stop(0);
    m_control.receive(m_robot.state());
    EXPECT_TRUE(m_control.status(at(0)).sent);
    EXPECT_FALSE(m_control.allowsDriving());
    EXPECT_TRUE(due(0));
}

TEST_F(Control, StandingIsWhatOdometrySays) {
    StopStateSample state = m_robot.state();
    EXPECT_FALSE(m_control.status(at(0)).standingKnown);
    state.standing = true;
    m_control.receive(state);
    EXPECT_TRUE(m_control.status(at(0)).standing);
    m_control.moved(0.2, 0.0, at(100));
    EXPECT_FALSE(m_control.status(at(100)).standing) << "odometry is newer";
    EXPECT_TRUE(m_control.status(at(1'200)).standing) << "none any more: the robot's own word";
}

TEST_F(Control, RobotsThatListenToNoStopsAreHeldByZeros) {
    StopControl plain("a", false);
    plain.stop(at(0), wallAt(0));
    EXPECT_FALSE(plain.due(at(0), wallAt(0)));
    EXPECT_TRUE(plain.holdsByZeros());
    EXPECT_FALSE(plain.allowsDriving());
    EXPECT_FALSE(plain.status(at(0)).supported);
    EXPECT_TRUE(plain.status(at(0)).sent);
    EXPECT_FALSE(plain.release(false, at(0), wallAt(0)).ok());
    EXPECT_TRUE(plain.release(true, at(0), wallAt(0)).ok());
    EXPECT_FALSE(plain.holdsByZeros());
    EXPECT_TRUE(plain.allowsDriving());
}

}  // namespace
}  // namespace leitstand::test
