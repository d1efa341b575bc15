#include <algorithm>
#include <csignal>

#include <gmock/gmock.h>

#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> mismatchTexts(const Node& node) {
    std::vector<std::string> texts;
    for (const Mismatch& mismatch : node.mismatches()) texts.push_back(toString(mismatch.complaint));
    return texts;
}

/// The words of @p node once it has any.
std::vector<std::string> awaitedMismatches(const Node& node) {
    EXPECT_TRUE(waitUntil([&] { return !node.mismatches().empty(); }));
    return mismatchTexts(node);
}

TEST(Discovery, TellsEveryEndpointWithItsQos) {
    const TestDomain domain;
    const auto robot = nodeIn(domain, {.name = "kurt3d"});
    const Qos offered{.reliability = Qos::Reliability::Reliable,
                      .durability = Qos::Durability::TransientLocal,
                      .depth = 7,
                      .lifespan = 0.25,
                      .deadline = 0.5};
    const auto writer = must(robot->publisher({"/kurt3d/mode", "leitstand_msgs/msg/Mode", offered}));
    const auto reader = must(robot->subscribe({"Square", "ShapeType", bestEffort()}, [](ReceivedSample) {}));
    const auto station = nodeIn(domain);
    ASSERT_TRUE(waitUntil([&] { return station->endpoints().size() == 2; }));
    auto endpoints = station->endpoints();
    std::sort(endpoints.begin(), endpoints.end(), [](auto& a, auto& b) { return a.topic < b.topic; });
    const RemoteEndpoint& mode = endpoints[0];
    EXPECT_EQ(mode.kind, RemoteEndpoint::Kind::Writer);
    EXPECT_EQ(mode.topic, "/kurt3d/mode");
    EXPECT_EQ(mode.type, "leitstand_msgs/msg/Mode");
    EXPECT_TRUE(mode.ros);
    EXPECT_FALSE(mode.keyed);
    EXPECT_EQ(mode.participantName, "kurt3d");
    EXPECT_FALSE(mode.host.empty());
    EXPECT_EQ(mode.guid, writer->guid());
    EXPECT_EQ(mode.participant, robot->guid());
    Qos reported = offered;
    reported.depth = 1;
    EXPECT_EQ(mode.qos.reliability, reported.reliability);
    EXPECT_EQ(mode.qos.durability, reported.durability);
    EXPECT_NEAR(mode.qos.lifespan, reported.lifespan, 1e-6);
    EXPECT_NEAR(mode.qos.deadline, reported.deadline, 1e-6);
    EXPECT_EQ(endpoints[1].kind, RemoteEndpoint::Kind::Reader);
    EXPECT_EQ(endpoints[1].topic, "Square");
    EXPECT_EQ(endpoints[1].type, "ShapeType");
    EXPECT_FALSE(endpoints[1].ros);
    ASSERT_EQ(station->participants().size(), 1U);
    EXPECT_EQ(station->participants()[0].name, "kurt3d");
    EXPECT_FALSE(station->participants()[0].refused);
}

TEST(Discovery, ChangesAreTold) {
    const TestDomain domain;
    const auto station = nodeIn(domain);
    std::atomic<int> reported = 0;
    station->onDiscovery([&] { ++reported; });
    ASSERT_TRUE(waitUntil([&] { return reported > 0; }));
    auto robot = nodeIn(domain);
    auto writer = must(robot->publisher({"/k/odom", TestType, reliable(1)}));
    ASSERT_TRUE(waitUntil([&] { return station->endpoints().size() == 1; }));
    const int before = reported;
    writer.reset();
    ASSERT_TRUE(waitUntil([&] { return station->endpoints().empty() && reported > before; }));
    robot.reset();
    ASSERT_TRUE(waitUntil([&] { return station->participants().empty(); }));
}

TEST(Mismatches, BestEffortDoesNotMeetReliable) {
    const TestDomain domain;
    const auto robot = nodeIn(domain);
    const auto odom = must(robot->publisher({"/kurt3d/odom", TestType, bestEffort()}));
    const auto drive =
        must(robot->subscribe({"/kurt3d/cmd_vel", TestType, reliable(1)}, [](ReceivedSample) {}));
    const auto station = nodeIn(domain);
    auto listening = must(station->subscribe({"/kurt3d/odom", TestType, reliable(1)}, [](ReceivedSample) {}));
    EXPECT_THAT(awaitedMismatches(*station),
                ElementsAre("/kurt3d/odom: robot offers best effort, we asked for reliable"));
    EXPECT_EQ(station->mismatches()[0].remote, odom->guid());
    listening.reset();
    EXPECT_THAT(mismatchTexts(*station), IsEmpty());
    const auto talking = must(station->publisher({"/kurt3d/cmd_vel", TestType, bestEffort()}));
    EXPECT_THAT(awaitedMismatches(*station),
                ElementsAre("/kurt3d/cmd_vel: we offer best effort, robot asks for reliable"));
}

TEST(Mismatches, TypesDurabilityAndDeadlines) {
    const TestDomain domain;
    const auto robot = nodeIn(domain);
    const auto scan = must(robot->publisher({"/k/scan", "sensor_msgs/msg/LaserScan", reliable(1)}));
    const auto mode = must(robot->publisher({"/k/mode", TestType, reliable(1)}));
    const auto station = nodeIn(domain);
    {
        const auto listening = must(station->subscribe(
            {"/k/scan", "sensor_msgs/msg/PointCloud2", reliable(1)}, [](ReceivedSample) {}));
        EXPECT_THAT(awaitedMismatches(*station),
                    ElementsAre("/k/scan: robot sends sensor_msgs/msg/LaserScan, we "
                                "expected sensor_msgs/msg/PointCloud2"));
    }
    Qos asked = transientLocal(1);
    asked.deadline = 0.5;
    const auto listening = must(station->subscribe({"/k/mode", TestType, asked}, [](ReceivedSample) {}));
    EXPECT_THAT(awaitedMismatches(*station),
                ElementsAre("/k/mode: robot offers volatile, we asked for transient local; robot offers no "
                            "deadline, we asked for a deadline of 0.5 s"));
}

TEST(Mismatches, NoneWhereOffersExceedRequests) {
    const TestDomain domain;
    const auto robot = nodeIn(domain);
    const auto writer = must(robot->publisher({"/k/odom", TestType, transientLocal(3)}));
    const auto station = nodeIn(domain);
    const auto listening =
        must(station->subscribe({"/k/odom", TestType, bestEffort()}, [](ReceivedSample) {}));
    ASSERT_TRUE(waitUntil([&] { return listening->counts().writers == 1; }));
    EXPECT_THAT(mismatchTexts(*station), IsEmpty());
}

TEST(Reconnection, AKilledRobotThatComesBackIsHeardAgain) {
    const TestDomain domain;
    const auto station = nodeIn(domain);
    Inbox inbox;
    const auto listening = must(station->subscribe({"/k/odom", TestType, bestEffort()}, inbox.callback()));
    const std::vector<std::string> words = {"talk", std::to_string(domain.number()), "/k/odom"};
    for (int life = 0; life < 3; ++life) {
        const ChildProcess robot(program("dds_peer"), words);
        ASSERT_TRUE(inbox.waitFor(inbox.size() + 10)) << "life " << life;
        robot.signal(SIGKILL);
    }
}

TEST(Reconnection, AKilledRobotIsForgottenAfterItsLease) {
    const TestDomain domain;
    const auto station = nodeIn(domain);
    const ChildProcess robot(program("dds_peer"),
                             {"talk", std::to_string(domain.number()), "/k/odom", "lease=1"});
    ASSERT_TRUE(waitUntil([&] { return station->endpoints().size() == 1; }));
    robot.signal(SIGKILL);
    EXPECT_TRUE(waitUntil([&] { return station->endpoints().empty() && station->participants().empty(); }));
}

}  // namespace
}  // namespace leitstand::test
