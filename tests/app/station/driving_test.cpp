// The rules of driving (docs/design.md, "The window") case by case, from the operator's hand to the robot
// over DDS.
#include "tests/app/station/seeing_robot.h"
#include "tests/app/station/station_scene.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Pictures = SeeingRobot::Pictures;

class DrivingTest : public StationScene {
protected:
    void begin(const RobotDescription& description) {
        m_robot = std::make_unique<SeeingRobot>(*m_node, description);
        m_station = stationFor({description});
    }
    [[nodiscard]] DriveView drive() const { return m_station->robot("kurt3d").drive; }
    /// Takes the sticks, as an operator would, until it moves at @p speed or more.
    [[nodiscard]] bool drives(double speed = 0.2) {
        return StationScene::drive(*m_station, "kurt3d", {0.3, 0.0, 0.0},
                                   [&] { return m_robot->speed() >= speed; });
    }
    /// For failures.
    [[nodiscard]] std::string sight() const {
        const SightCap cap = drive().sight;
        return "factor " + std::to_string(cap.factor) + " reason " + std::to_string(int(cap.reason)) +
               " age " + std::to_string(cap.age) + "\n" + words();
    }
    /// Holds the stick until @p condition.
    template <class Condition>
    [[nodiscard]] bool holdUntil(Condition condition, std::chrono::milliseconds atMost = 20s,
                                 bool withoutEyes = false) {
        return waitUntil(
            [&] {
                m_station->setStick({0.3, 0.0, 0.0}, withoutEyes);
                return condition();
            },
            atMost);
    }
    [[nodiscard]] bool stands() const { return m_robot->speed() == 0.0; }
    [[nodiscard]] bool goneNeutral() {
        return waitUntil([&] {
            m_station->setStick({});
            return drive().driving && !drive().needsNeutral;
        });
    }

    const std::unique_ptr<Node> m_node = nodeIn(m_domain);
    std::unique_ptr<SeeingRobot> m_robot;
    std::unique_ptr<Station> m_station;
};

TEST_F(DrivingTest, PicturesThatFreezeCapTheSpeedAndThenStopTheRobot) {
    begin(seeingRobot(true, false));
    ASSERT_TRUE(drives()) << sight();
    m_robot->pictures = Pictures::Frozen;
    ASSERT_TRUE(holdUntil([&] { return m_robot->speed() <= 0.101; })) << "creep speed";
    ASSERT_TRUE(holdUntil([&] { return stands() && drive().sight.factor == 0.0; }));
    EXPECT_EQ(drive().sight.reason, SightReason::FrozenPicture);
    m_robot->pictures = Pictures::Live;
    ASSERT_TRUE(holdUntil([&] { return drive().sight.factor == 1.0; }));
    EXPECT_FALSE(holdUntil([&] { return !stands(); }, 300ms)) << "motion never resumes by itself";
    ASSERT_TRUE(goneNeutral());
    EXPECT_TRUE(holdUntil([&] { return m_robot->speed() >= 0.2; }));
}

TEST_F(DrivingTest, PicturesThatStopComingStopTheRobotAndTheOverrideIsHeld) {
    begin(seeingRobot(true, false));
    ASSERT_TRUE(drives()) << sight();
    m_robot->pictures = Pictures::Off;
    ASSERT_TRUE(holdUntil([&] { return stands() && drive().sight.reason == SightReason::OldPicture; }));
    EXPECT_FALSE(holdUntil([&] { return !stands(); }, 300ms, true))
        << "sticks that were held when it stopped come first";
    ASSERT_TRUE(goneNeutral());
    ASSERT_TRUE(holdUntil([&] { return m_robot->speed() >= 0.2; }, 20s, true))
        << sight() << " neutral " << drive().needsNeutral << " driving " << drive().driving;
    EXPECT_TRUE(drive().sight.overridden);
    EXPECT_TRUE(drive().sight.isBlind());
    EXPECT_TRUE(holdUntil([&] { return stands(); })) << "let go";
}

TEST_F(DrivingTest, AFreshVirtualScanCountsAsEyes) {
    begin(seeingRobot());
    m_robot->pictures = Pictures::Off;
    ASSERT_TRUE(drives()) << sight();
    EXPECT_EQ(drive().sight.reason, SightReason::ScanAlone);
    m_robot->scans = false;
    ASSERT_TRUE(holdUntil([&] { return stands() && drive().sight.factor == 0.0; }));
}

TEST_F(DrivingTest, ARobotWithoutCameraDrivesByItsScan) {
    begin(seeingRobot(false, true));
    ASSERT_TRUE(drives()) << sight();
    m_robot->scans = false;
    ASSERT_TRUE(holdUntil([&] { return stands() && drive().sight.factor == 0.0; }));
    EXPECT_EQ(drive().sight.reason, SightReason::OldScan);
}

TEST_F(DrivingTest, UnpluggedInputStops) {
    begin(drivenRobot());
    ASSERT_TRUE(drives()) << sight();
    EXPECT_TRUE(waitUntil([&] { return stands(); }, 5s)) << "nobody tells the sticks any more";
    EXPECT_TRUE(drive().focus);
}

TEST_F(DrivingTest, LostFocusStopsAndItComesBackWithNeutralSticks) {
    begin(drivenRobot());
    ASSERT_TRUE(drives()) << sight();
    m_station->setDriveFocus({});
    ASSERT_TRUE(holdUntil([&] { return stands(); }));
    m_station->setDriveFocus("kurt3d");
    EXPECT_FALSE(holdUntil([&] { return !stands(); }, 300ms));
    EXPECT_TRUE(drive().needsNeutral);
    ASSERT_TRUE(goneNeutral());
    EXPECT_TRUE(holdUntil([&] { return m_robot->speed() >= 0.2; }));
}

TEST_F(DrivingTest, AGrantGivenToAnotherStationStops) {
    const RobotDescription description = drivenRobot();
    begin(description);
    ASSERT_TRUE(drives()) << sight();
    const auto other = stationFor({description}, "other");
    other->requestGrant("kurt3d");
    ASSERT_TRUE(holdUntil([&] { return !m_station->robot("kurt3d").grant.requestedBy.empty(); }));
    m_station->answerRequest("kurt3d", true);
    ASSERT_TRUE(holdUntil([&] { return stands() && other->robot("kurt3d").grant.mine; }));
    EXPECT_FALSE(holdUntil([&] { return !stands(); }, 300ms)) << "the sticks are still held here";
}

TEST_F(DrivingTest, SpaceHaltsUntilTheSticksWereNeutral) {
    begin(drivenRobot());
    ASSERT_TRUE(drives()) << sight();
    m_station->halt();
    ASSERT_TRUE(holdUntil([&] { return stands(); }));
    EXPECT_FALSE(holdUntil([&] { return !stands(); }, 300ms));
    ASSERT_TRUE(goneNeutral());
    EXPECT_TRUE(holdUntil([&] { return m_robot->speed() >= 0.2; }));
}

TEST_F(DrivingTest, AfterALostLinkSticksAreNeutralFirst) {
    const RobotDescription description = drivenRobot();
    begin(description);
    ASSERT_TRUE(drives()) << sight();
    m_robot.reset();
    ASSERT_TRUE(holdUntil([&] { return m_station->robot("kurt3d").link.state == LinkState::Lost; }));
    ASSERT_TRUE(holdUntil([&] { return !drive().driving; }));
    m_robot = std::make_unique<SeeingRobot>(*m_node, description);
    ASSERT_TRUE(holdUntil([&] { return m_station->robot("kurt3d").link.state != LinkState::Lost; }));
    ASSERT_TRUE(holdUntil([&] { return drive().needsNeutral; }))
        << "focus " << drive().focus << " driving " << drive().driving << " stopped "
        << m_station->robot("kurt3d").stop.stopped << " grant " << m_station->robot("kurt3d").grant.mine;
    EXPECT_TRUE(stands());
    EXPECT_TRUE(drives());
}

}  // namespace
}  // namespace leitstand::test
