#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "transport/dds/guid.h"
#include "transport/dds/node.h"

namespace leitstand {

/// DDS name and type of the topic on which processes of ROS 2 announce their nodes (rmw_dds_common).
inline constexpr std::string_view RosDiscoveryTopic = "ros_discovery_info";
inline constexpr std::string_view RosDiscoveryType = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";

/// A node of ROS 2, as its process announces it.
struct RosNode {
    std::string name;  ///< full name: "/kurt3d/driver"
    std::vector<Guid> readers, writers;
};

/// The nodes of a process (rmw_dds_common/msg/ParticipantEntitiesInfo).
struct RosProcess {
    Guid participant;
    std::size_t gidSize = 0;  ///< bytes of an identity in messages: 24 until Humble, 16 from Iron on
    std::vector<RosNode> nodes;
};
/// Reads an announcement of nodes, whose identities may have 16 or 24 bytes. @p cdr may contain any bytes;
/// error when it is no such announcement.
[[nodiscard]] Result<RosProcess> rosProcess(std::span<const std::byte> cdr);

/// Returns the announcement of @p process, with identities of RosProcess::gidSize bytes (16 or 24).
[[nodiscard]] Payload rosAnnouncement(const RosProcess& process);

/// Finds the ROS 2 nodes to which the readers and writers of a domain belong. Any thread.
class RosNodes {
public:
    void add(const RosProcess& process);  ///< replaces the process's previous announcement
    /// Returns the full name of the node that has @p endpoint; empty: unknown.
    [[nodiscard]] std::string of(const Guid& endpoint) const;
    /// Returns the size of identities in the announcements of those of @p participants that announced nodes
    /// other than @p unlike. Empty: none did, or they use different sizes.
    [[nodiscard]] std::optional<std::size_t> gidSize(std::span<const Guid> participants,
                                                     const std::string& unlike = {}) const;

private:
    static constexpr std::size_t MostProcesses = 1'000, MostEndpoints = 100'000;

    mutable std::mutex m_mutex;
    std::map<Guid, RosProcess> m_processes;  ///< by participant
    std::map<Guid, std::string> m_nodes;     ///< by endpoint
};

/// Receives the announcements of processes; publishes nothing.
class RosNodeWatch {
public:
    /// @p node must outlive this object. Without permission to read the topic, no node is known.
    explicit RosNodeWatch(Node& node);
    [[nodiscard]] const RosNodes& nodes() const { return *m_nodes; }

private:
    std::shared_ptr<RosNodes> m_nodes = std::make_shared<RosNodes>();
    std::unique_ptr<Subscription> m_subscription;
};

}  // namespace leitstand
