#include <atomic>
#include <mutex>
#include <optional>

#include <gmock/gmock.h>

#include "tests/transport/dds/test_node.h"
#include "transport/services/navigation_client.h"
#include "transport/services/navigation_messages.h"
#include "transport/services/navigation_server.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::byte>;

PoseSample place(double x, double y) {
    PoseSample goal;
    goal.header.frame = "odom";
    goal.poseInFrame.translation() = Eigen::Vector3d(x, y, 0.0);
    return goal;
}

TEST(NavigationMessages, AreReadAsTheyWereWritten) {
    const NavigationGoal goal{{1, 2, 3}, place(1.5, -2.0)};
    const auto read = decodeGoal(**encodeGoal(goal));
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->id, goal.id);
    EXPECT_EQ(read->goal.header.frame, "odom");
    EXPECT_TRUE(read->goal.poseInFrame.isApprox(goal.goal.poseInFrame));
    EXPECT_EQ(decodeCancel(*encodeCancel(goal.id)).value(), goal.id);
    for (const bool accepted : {false, true})
        EXPECT_EQ(*decodeAcceptance(*encodeAcceptance(accepted)), accepted);
    const auto progress = decodeProgress(*encodeProgress({goal.id, 12.25, 2, 3.5}));
    ASSERT_TRUE(progress) << progress.error().text;
    EXPECT_EQ(progress->id, goal.id);
    EXPECT_NEAR(progress->seconds, 12.25, 1e-6);
    EXPECT_EQ(progress->recoveries, 2);
    EXPECT_EQ(progress->metres, 3.5);
    const std::vector<GoalTracker::Report> reports = {{goal.id, GoalTracker::Status::Executing},
                                                      {{9}, GoalTracker::Status::Aborted}};
    const auto goals = decodeStatus(*encodeStatus(reports));
    ASSERT_TRUE(goals) << goals.error().text;
    ASSERT_EQ(goals->size(), 2U);
    EXPECT_EQ(goals->front().goal, goal.id);
    EXPECT_EQ(goals->back().status, GoalTracker::Status::Aborted);
}

TEST(NavigationMessages, HaveTheNamesAndTheLayoutOfRos2) {
    const ActionNames names = actionNames("/tb1/navigate_to_pose", NavigateToPose);
    EXPECT_EQ(names.sendGoal, "/tb1/navigate_to_pose/_action/send_goal");
    EXPECT_EQ(names.sendGoalType, "nav2_msgs/action/NavigateToPose_SendGoal");
    EXPECT_EQ(names.feedbackType, "nav2_msgs/action/NavigateToPose_FeedbackMessage");
    // UUID 16, stamp 8, frame 4 + 5 and 3 of padding, pose 56, behaviour tree 4 + 1.
    EXPECT_EQ((*encodeGoal({{}, place(0, 0)}))->size(), 4U + 16U + 8U + 12U + 4U + 56U + 5U);
}

TEST(NavigationMessages, HostileOnesAreRefused) {
    const Bytes goal = **encodeGoal({{1}, place(1, 2)});
    for (std::size_t size = 0; size + 5 < goal.size(); ++size)
        EXPECT_FALSE(decodeGoal(std::span(goal).first(size))) << size;
    PoseSample nowhere = place(std::nan(""), 0);
    EXPECT_FALSE(encodeGoal({{}, nowhere}));
    Bytes broken = goal;
    for (std::size_t i = broken.size() - 64; i < broken.size() - 40; ++i) broken[i] = std::byte{0xff};  // NaN
    EXPECT_FALSE(decodeGoal(broken));
    Bytes status = *encodeStatus({});
    for (std::size_t i = 4; i < 8; ++i) status[i] = std::byte{0xff};
    EXPECT_FALSE(decodeStatus(status));
    EXPECT_FALSE(decodeProgress({}) || decodeAcceptance({}) || decodeCancel({}) || decodeStatus({}));
    const std::vector<GoalTracker::Report> odd = {{{1}, static_cast<GoalTracker::Status>(99)}};
    EXPECT_EQ(decodeStatus(*encodeStatus(odd))->front().status, GoalTracker::Status::Unknown);
}

/// A robot's navigation and a station.
class Navigation : public testing::Test {
protected:
    void serve() {
        NavigationServer::Calls calls;
        calls.go = [this](const NavigationGoal& goal) {
            const std::lock_guard lock(m_mutex);
            m_goal = goal;
            return m_accepts.load();
        };
        calls.cancel = [this](const GoalId& goal) {
            const std::lock_guard lock(m_mutex);
            m_cancelled = goal;
            return true;
        };
        m_server = must(NavigationServer::create(*m_robot, "/k/navigate_to_pose", calls));
    }
    [[nodiscard]] bool isOffered() const {
        return waitUntil([&] { return m_client->view().offered; });
    }
    /// Sends the robot to @p goal until it heard that: a server may find a client later than it is found.
    [[nodiscard]] bool goes(const PoseSample& goal) {
        return waitUntil([&] {
            return m_client->go(goal) && waitUntil([&] { return stage() != GoalStage::Asked; }, 500ms);
        });
    }
    [[nodiscard]] GoalStage stage() const { return m_client->view().stage; }
    [[nodiscard]] bool reaches(GoalStage wanted) const {
        return waitUntil([&] { return stage() == wanted; });
    }
    [[nodiscard]] NavigationGoal goal() const {
        const std::lock_guard lock(m_mutex);
        return m_goal.value_or(NavigationGoal{});
    }
    void report(GoalTracker::Status status) {
        const std::vector<GoalTracker::Report> all = {{goal().id, status}};
        m_server->report(all);
    }

    const TestDomain m_domain;
    mutable std::mutex m_mutex;
    std::optional<NavigationGoal> m_goal;
    std::optional<GoalId> m_cancelled;
    std::atomic<bool> m_accepts = true;
    std::unique_ptr<Node> m_robot = nodeIn(m_domain), m_station = nodeIn(m_domain);
    std::unique_ptr<NavigationServer> m_server;
    std::unique_ptr<NavigationClient> m_client =
        must(NavigationClient::create(*m_station, "/k/navigate_to_pose"));
};

TEST_F(Navigation, TakesGoalsAndTellsTheWay) {
    EXPECT_TRUE(m_client->view().known);
    EXPECT_FALSE(m_client->go(place(1, 2))) << "nobody is there";
    EXPECT_EQ(stage(), GoalStage::Refused) << "it never went out";
    serve();
    ASSERT_TRUE(isOffered());
    ASSERT_TRUE(goes(place(1, 2)));
    EXPECT_EQ(stage(), GoalStage::UnderWay);
    EXPECT_EQ(goal().goal.poseInFrame.translation().y(), 2.0);
    const bool told = waitUntil([&] {
        m_server->progress({goal().id, 4.0, 0, 2.0});
        std::this_thread::sleep_for(20ms);
        return m_client->view().metresLeft == 2.0;
    });
    EXPECT_TRUE(told);
    report(GoalTracker::Status::Succeeded);
    EXPECT_TRUE(reaches(GoalStage::Arrived));
}

TEST_F(Navigation, AGoalIsCancelled) {
    serve();
    ASSERT_TRUE(isOffered());
    m_client->cancel();  // there is none
    ASSERT_TRUE(goes(place(1, 2)));
    m_client->cancel();
    EXPECT_EQ(stage(), GoalStage::Cancelling);
    EXPECT_TRUE(waitUntil([&] {
        const std::lock_guard lock(m_mutex);
        return m_cancelled == m_goal->id;
    }));
    report(GoalTracker::Status::Canceled);
    EXPECT_TRUE(reaches(GoalStage::Cancelled));
}

TEST_F(Navigation, ARefusedGoalIsTold) {
    serve();
    m_accepts = false;
    ASSERT_TRUE(isOffered());
    ASSERT_TRUE(goes(place(1, 2)));
    EXPECT_EQ(stage(), GoalStage::Refused);
}

TEST_F(Navigation, ANewerGoalReplacesTheOneBefore) {
    serve();
    ASSERT_TRUE(isOffered());
    ASSERT_TRUE(goes(place(1, 2)));
    const GoalId first = goal().id;
    ASSERT_TRUE(goes(place(3, 4)));
    EXPECT_NE(goal().id, first);
    const std::vector<GoalTracker::Report> both = {{first, GoalTracker::Status::Aborted},
                                                   {goal().id, GoalTracker::Status::Executing}};
    m_server->report(both);
    std::this_thread::sleep_for(200ms);
    EXPECT_EQ(stage(), GoalStage::UnderWay);
}

}  // namespace
}  // namespace leitstand::test
