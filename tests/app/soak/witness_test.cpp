#include "tests/app/soak/witness.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "core/event/stream_role.h"
#include "tests/app/recording.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

RobotDescription plainRobot() {
    StreamDescription odometry;
    odometry.role = StreamRole::Odometry;
    odometry.topic = "/k/odom";
    odometry.type = "nav_msgs/msg/Odometry";
    odometry.qos = reliable(100);
    RobotDescription robot;
    robot.name = "k";
    robot.streams = {odometry};
    return robot;
}

/// Says something else 50 times a second.
class Speaker {
public:
    Speaker(const TestDomain& domain, const StreamDescription& stream)
        : m_node(nodeIn(domain, {.interfaces = {"lo"}})),
          m_publisher(must(m_node->publisher({stream.topic, stream.type, stream.qos}))),
          m_thread([this](const std::stop_token& stop) {
              for (std::uint32_t i = 1; !stop.stop_requested(); ++i) {
                  EXPECT_TRUE(m_publisher->write(testPayload(64, i)).ok());
                  std::this_thread::sleep_for(20ms);
              }
              EXPECT_TRUE(m_publisher->waitForAcknowledgments(10s));
          }) {}

private:
    std::unique_ptr<Node> m_node;
    std::unique_ptr<Publisher> m_publisher;
    std::jthread m_thread;  ///< last: joined first
};

/// Takes a message out of the middle of a log of one file.
void takeOneOut(const std::filesystem::path& mission) {
    for (const auto& file : std::filesystem::directory_iterator(mission)) {
        if (file.path().extension() != ".db3") continue;
        sqlite3* database = nullptr;
        ASSERT_EQ(sqlite3_open(file.path().c_str(), &database), SQLITE_OK);
        const char* sql = "DELETE FROM messages WHERE id = (SELECT (min(id) + max(id)) / 2 FROM messages)";
        EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK);
        EXPECT_EQ(sqlite3_changes(database), 1);
        sqlite3_close(database);
    }
}

TEST(Witness, TellsOfASampleThatIsMissingInALog) {
    const TestDomain domain;
    const TemporaryFolder folder;
    const auto mission = folder / "mission";
    const RobotDescription robot = plainRobot();
    Recording recording(domain, mission, {"--interface", "lo"});
    std::optional<Speaker> speaker(std::in_place, domain, robot.streams.front());
    ASSERT_TRUE(waitUntil([&] { return !recordedOn(mission, "/k/odom").empty(); }, 60s));
    Witness witness(domain, {robot});
    ASSERT_TRUE(witness.listen() && witness.listen());
    speaker.reset();
    EXPECT_EQ(recording.stop(), 0);

    const Kept whole = witness.compare(mission).at(0);
    EXPECT_TRUE(whole.reliable);
    EXPECT_GT(whole.sent, 100U);
    EXPECT_EQ(whole.logged, whole.sent);
    takeOneOut(mission);
    const Kept lacking = witness.compare(mission).at(0);
    EXPECT_EQ(lacking.sent, whole.sent);
    EXPECT_EQ(lacking.logged, whole.sent - 1);
}

}  // namespace
}  // namespace leitstand::test
