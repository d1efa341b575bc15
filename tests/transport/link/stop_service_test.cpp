#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include <gmock/gmock.h>

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/transport/link/control_robot.h"
#include "tests/transport/link/control_station.h"
#include "transport/services/service_server.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Stage = StopServiceStatus::Stage;

/// A stock robot: it knows no stops, but has an e-stop and a navigation whose goals can be cancelled.
class StopByService : public testing::Test {
protected:
    static RobotDescription stockRobot() {
        RobotDescription robot = drivenRobot();
        std::erase_if(robot.streams, [](const StreamDescription& stream) {
            return stream.role == StreamRole::StopCommand || stream.role == StreamRole::StopState;
        });
        robot.streams.push_back(defaultStream(StreamRole::StopLock, robot.name, {}));
        robot.services = {
            {.name = "/kurt3d/e_stop", .type = "std_srvs/srv/SetBool", .title = "E-stop", .stop = true},
            {.name = "/kurt3d/navigate_to_pose/_action/cancel_goal",
             .type = "action_msgs/srv/CancelGoal",
             .title = "Goals",
             .stop = true},
            {.name = "/kurt3d/lamp", .type = "std_srvs/srv/SetBool"}};
        return robot;
    }
    /// Offers service @p index of the robot; m_refusesRelease and m_answers say what it answers.
    std::unique_ptr<ServiceServer> offer(Node& node, std::size_t index) {
        const ServiceDescription& service = m_description.services[index];
        return must(ServiceServer::create(
            node, service.name, service.type, [this, index](const ServiceRequest& request) {
                const std::lock_guard lock(m_mutex);
                m_asked.emplace_back(index, request.value);
                const bool refuses = m_refusesRelease && index == 0 && !request.value;
                return m_answers ? std::optional(ServiceAnswer{!refuses, "no"}) : std::nullopt;
            }));
    }
    using Asked = std::vector<std::pair<std::size_t, bool>>;
    [[nodiscard]] Asked asked() const {
        const std::lock_guard lock(m_mutex);
        return m_asked;
    }
    [[nodiscard]] StopServiceStatus statusOf(std::size_t index) const {
        return m_stops->status("kurt3d").services.at(index);
    }
    [[nodiscard]] bool reaches(std::size_t index, Stage stage) const {
        return waitUntil([&] { return statusOf(index).stage == stage; });
    }
    [[nodiscard]] bool isOffered() const {
        return waitUntil([&] { return statusOf(0).offered && statusOf(1).offered; });
    }

    const TestDomain m_domain;
    const RobotDescription m_description = stockRobot();
    mutable std::mutex m_mutex;
    Asked m_asked;
    std::atomic<bool> m_refusesRelease = false, m_answers = true;
    std::unique_ptr<Node> m_robot = nodeIn(m_domain), m_node = nodeIn(m_domain);
    std::unique_ptr<ServiceServer> m_eStop = offer(*m_robot, 0), m_goals = offer(*m_robot, 1),
                                   m_lamp = offer(*m_robot, 2);
    std::unique_ptr<StopSender> m_stops =
        must(StopSender::create(*m_node, std::vector{m_description},
                                {.station = "a", .mayRelease = [](const std::string&) { return true; }}));
};

TEST_F(StopByService, StopsByEachAndReleasesTheEStop) {
    ASSERT_EQ(m_stops->status("kurt3d").services.size(), 2U) << "the lamp has no part in it";
    ASSERT_TRUE(isOffered());
    EXPECT_TRUE(asked().empty());
    m_stops->stopAll();
    EXPECT_TRUE(m_stops->holdsByZeros("kurt3d")) << "besides";
    ASSERT_TRUE(reaches(0, Stage::Stopped) && reaches(1, Stage::Stopped));
    EXPECT_THAT(asked(), testing::IsSupersetOf(Asked{{0, true}, {1, false}}));
    ASSERT_TRUE(m_stops->release("kurt3d").ok());
    ASSERT_TRUE(reaches(0, Stage::Idle) && reaches(1, Stage::Idle));
    EXPECT_EQ(asked().back(), (std::pair<std::size_t, bool>{0, false}));
    EXPECT_TRUE(waitUntil([&] { return m_stops->allowsDriving("kurt3d"); }));
}

TEST_F(StopByService, ANewServerIsStoppedAsWell) {
    ASSERT_TRUE(isOffered());
    m_stops->stopAll();
    ASSERT_TRUE(reaches(0, Stage::Stopped));
    m_eStop.reset();
    ASSERT_TRUE(waitUntil([&] { return !statusOf(0).offered; }));
    const std::size_t before = asked().size();
    m_eStop = offer(*m_robot, 0);
    EXPECT_TRUE(waitUntil([&] { return asked().size() > before; }));
    EXPECT_TRUE(reaches(0, Stage::Stopped));
}

TEST_F(StopByService, ARefusedReleaseStopsTheWholeRobotAgainAndSaysWhy) {
    ASSERT_TRUE(isOffered());
    m_stops->stopAll();
    ASSERT_TRUE(reaches(0, Stage::Stopped));
    m_refusesRelease = true;
    ASSERT_TRUE(m_stops->release("kurt3d").ok());
    ASSERT_TRUE(waitUntil([&] { return m_stops->holdsByZeros("kurt3d"); }));
    ASSERT_TRUE(reaches(0, Stage::Stopped) && reaches(1, Stage::Stopped)) << "goals sent meanwhile end, too";
    EXPECT_FALSE(m_stops->allowsDriving("kurt3d"));
    EXPECT_EQ(m_stops->status("kurt3d").refused, "E-stop refuses: no");
    m_refusesRelease = false;
    ASSERT_TRUE(m_stops->release("kurt3d").ok());
    ASSERT_TRUE(reaches(0, Stage::Idle));
    EXPECT_EQ(m_stops->status("kurt3d").refused, "");
}

TEST_F(StopByService, DrivingWaitsForTheRelease) {
    ASSERT_TRUE(isOffered());
    m_stops->stopAll();
    ASSERT_TRUE(reaches(0, Stage::Stopped));
    m_answers = false;
    ASSERT_TRUE(m_stops->release("kurt3d").ok());
    EXPECT_FALSE(m_stops->allowsDriving("kurt3d"));
    EXPECT_TRUE(m_stops->status("kurt3d").releasing);
    EXPECT_TRUE(waitUntil([&] { return m_stops->holdsByZeros("kurt3d"); })) << "revoked";
    EXPECT_FALSE(m_stops->allowsDriving("kurt3d"));
}

TEST_F(StopByService, OneThatHangsHoldsUpNeitherTheOthersNorTheLock) {
    const StreamDescription lock = *m_description.stream(StreamRole::StopLock);
    std::atomic<int> locks = 0;
    const auto mux = must(m_robot->subscribe({lock.topic, lock.type, lock.qos, Lane::Small},
                                             [&](const ReceivedSample&) { ++locks; }));
    ASSERT_TRUE(isOffered());
    ASSERT_TRUE(waitUntil([&] { return m_stops->status("kurt3d").lockHeard; }));
    m_eStop = must(ServiceServer::create(*m_robot, "/kurt3d/e_stop", "std_srvs/srv/SetBool",
                                         [](const ServiceRequest&) { return std::nullopt; }));
    m_stops->stopAll();
    EXPECT_TRUE(reaches(1, Stage::Stopped));
    EXPECT_TRUE(waitUntil([&] { return locks >= 5; }));
    EXPECT_EQ(statusOf(0).stage, Stage::Asked);
}

}  // namespace
}  // namespace leitstand::test
