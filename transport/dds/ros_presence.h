#pragma once

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "transport/dds/node.h"
#include "transport/dds/ros_nodes.h"

namespace leitstand {

/// Announces this process to the processes of ROS 2 in its domain, so that `ros2 node list` and `ros2 topic
/// info -v` show it. Identities in announcements have 24 bytes until Humble and 16 from Iron on, and a wrong
/// size breaks the processes that read it. So it announces only in the one size that it hears, and nothing
/// where it hears none, or both. It looks once a second.
class RosPresence {
public:
    /// @p name: full name of the node, "/leitstand". @p node and @p others must outlive this object.
    RosPresence(Node& node, const RosNodes& others, std::string name);
    RosPresence(const RosPresence&) = delete;
    RosPresence& operator=(const RosPresence&) = delete;

private:
    void run(const std::stop_token& stop);
    void look();

    Node& m_node;
    const RosNodes& m_others;
    const std::string m_name;
    // Used by the thread alone.
    std::unique_ptr<Publisher> m_publisher;
    std::size_t m_size = 0;
    Guid m_me;
    Node::OwnEndpoints m_announced;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
