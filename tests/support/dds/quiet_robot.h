#pragma once

#include <cstddef>
#include <memory>
#include <set>

#include "core/event/stream_role.h"
#include "core/robot/robot_description.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {

/// A robot whose odometry is announced, and comes only when it is told to.
class QuietRobot {
public:
    QuietRobot(const TestDomain& domain, const RobotDescription& robot)
        : m_node(nodeIn(domain, {.name = robot.name})), m_stream(*robot.stream(StreamRole::Odometry)) {
        m_odometry = must(m_node->publisher({m_stream.topic, m_stream.type, m_stream.qos}));
    }
    void speak() { static_cast<void>(m_odometry->write(testPayload(700, 1))); }
    /// Participants that it has seen so far: who joined anew counts twice.
    std::size_t seen() {
        for (const RemoteParticipant& one : m_node->participants()) m_seen.insert(one.guid);
        return m_seen.size();
    }

private:
    std::unique_ptr<Node> m_node;
    const StreamDescription m_stream;
    std::unique_ptr<Publisher> m_odometry;
    std::set<Guid> m_seen;
};

}  // namespace leitstand::test
