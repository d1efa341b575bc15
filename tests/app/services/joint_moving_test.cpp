#include "app/services/station/joints/joint_moving.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

RobotDescription robotWithFlippers() {
    RobotDescription robot;
    robot.name = "tracked";
    JointGroup group;
    group.name = "flippers";
    group.mode = JointCommandMode::Velocity;
    MovedJoint joint;
    joint.name = "front";
    joint.rate = 0.5;
    group.joints = {joint};
    group.axes = {{"Front", {0}}};
    robot.jointGroups = {group};
    return robot;
}

/// A station's wire as far as joints need one.
struct FakeWire {
    std::atomic<bool> may = true, hold = false, fails = false;
    std::mutex mutex;
    std::vector<double> sent;
    std::vector<std::string> said;

    JointMoving::Wire wire() {
        return {[this](const std::string& robot) {
                    EXPECT_EQ(robot, "tracked");
                    return JointConditions{may, hold};
                },
                [this](const std::string&, const JointGroup& group, const JointSetpoints& setpoints) {
                    EXPECT_EQ(group.name, "flippers");
                    const std::scoped_lock lock(mutex);
                    sent.push_back(setpoints.values.at(0));
                    return fails ? Result<void>(Error{"the wire is cut"}) : Result<void>();
                },
                [this](const std::string& text) {
                    const std::scoped_lock lock(mutex);
                    said.push_back(text);
                }};
    }
    [[nodiscard]] double last() {
        const std::scoped_lock lock(mutex);
        return sent.empty() ? 0.0 : sent.back();
    }
};

TEST(JointMoving, SendsFromItsOwnThreadAndEndsWhenTheWindowHangs) {
    FakeWire fake;
    JointMoving joints({robotWithFlippers()}, fake.wire());
    joints.move("tracked", "flippers", 0, 0.0);
    joints.move("tracked", "flippers", 0, 1.0);
    EXPECT_TRUE(waitUntil([&] { return fake.last() == 0.5; }));
    EXPECT_TRUE(waitUntil([&] { return fake.last() == 0.0; })) << "nobody renewed it";
    EXPECT_FALSE(joints.view("tracked", "arm"));
    EXPECT_FALSE(joints.view("husky", "flippers"));
}

/// Moves the flippers until something is sent.
void moves(JointMoving& joints, FakeWire& fake) {
    joints.move("tracked", "flippers", 0, 0.0);
    joints.move("tracked", "flippers", 0, 1.0);
    ASSERT_TRUE(waitUntil([&] { return fake.last() == 0.5; }));
}

TEST(JointMoving, AStopIsZerosUntilTheRelease) {
    FakeWire fake;
    JointMoving joints({robotWithFlippers()}, fake.wire());
    moves(joints, fake);
    fake.may = false;
    fake.hold = true;
    ASSERT_TRUE(waitUntil([&] { return fake.last() == 0.0; }));
    const auto count = [&] {
        const std::scoped_lock lock(fake.mutex);
        return fake.sent.size();
    };
    const std::size_t before = count();
    ASSERT_TRUE(waitUntil([&] {
        joints.move("tracked", "flippers", 0, 1.0);  // the key is held on
        return count() > before + 30;
    }));
    EXPECT_EQ(fake.last(), 0.0);
    fake.may = true;
    fake.hold = false;
    for (int i = 0; i < 20; ++i) {
        joints.move("tracked", "flippers", 0, 1.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        EXPECT_EQ(fake.last(), 0.0) << "it must be let go first";
    }
}

TEST(JointMoving, ItsEndIsAZero) {
    FakeWire fake;
    {
        JointMoving joints({robotWithFlippers()}, fake.wire());
        moves(joints, fake);
        EXPECT_TRUE(joints.isMoving("tracked"));
        EXPECT_FALSE(joints.isMoving("husky"));
    }
    EXPECT_EQ(fake.last(), 0.0);
}

TEST(JointMoving, AHaltEndsAMotionThatIsStillAskedFor) {
    FakeWire fake;
    JointMoving joints({robotWithFlippers()}, fake.wire());
    moves(joints, fake);
    joints.halt("tracked");
    ASSERT_TRUE(waitUntil([&] {
        joints.move("tracked", "flippers", 0, 1.0);
        return fake.last() == 0.0;
    }));
}

TEST(JointMoving, TakesPositionsOfItsRobotOnly) {
    FakeWire fake;
    JointMoving joints({robotWithFlippers()}, fake.wire());
    Event event;
    event.role = StreamRole::Joints;
    JointSample sample;
    sample.names = {"front"};
    sample.positions = {0.25};
    event.sample = sample;
    event.robot = "husky";
    joints.onEvent(event);
    EXPECT_FALSE(joints.view("tracked", "flippers")->positions[0]);
    event.robot = "tracked";
    joints.onEvent(event);
    EXPECT_EQ(joints.view("tracked", "flippers")->positions[0], 0.25);
}

TEST(JointMoving, AFaultOfTheWireIsToldOnce) {
    FakeWire fake;
    fake.fails = true;
    JointMoving joints({robotWithFlippers()}, fake.wire());
    joints.move("tracked", "flippers", 0, 0.0);
    joints.move("tracked", "flippers", 0, 1.0);
    ASSERT_TRUE(waitUntil([&] {
        const std::scoped_lock lock(fake.mutex);
        return fake.sent.size() > 3;
    }));
    const std::scoped_lock lock(fake.mutex);
    EXPECT_THAT(fake.said, testing::ElementsAre("the wire is cut"));
}

}  // namespace
}  // namespace leitstand::test
