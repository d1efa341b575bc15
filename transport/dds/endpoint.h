#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/robot/link/wire_complaint.h"
#include "core/robot/streams/qos.h"
#include "transport/dds/guid.h"

namespace leitstand {

/// Another process (or part of one) in the domain.
struct RemoteParticipant {
    Guid guid;
    std::string name;      ///< its own name; "/" for ROS 2 nodes
    std::string host;      ///< its host name when announced, else its first address, "192.168.0.7"
    bool refused = false;  ///< it could not prove an identity that we accept (DDS-Security)
};

/// A writer or reader of another participant.
struct RemoteEndpoint {
    enum class Kind : std::uint8_t { Writer, Reader };
    Kind kind = Kind::Writer;
    Guid guid, participant;
    std::string participantName, host;  ///< as in RemoteParticipant
    std::string topic;                  ///< ROS name "/kurt3d/odom" where it is one, else the DDS name
    std::string type;    ///< ROS name "nav_msgs/msg/Odometry" where it is one, else the DDS name
    bool ros = false;    ///< the topic is one of ROS 2 ("rt/" on the wire)
    bool keyed = false;  ///< its instances have keys: not a ROS 2 topic
    bool exclusiveOwnership = false;
    std::vector<std::string> partitions;  ///< empty: the default partition
    /// What it offers or requests. DDS does not announce the depth of the history: it stays 1. Durabilities
    /// beyond transient local count as transient local.
    Qos qos;
};

/// A writer of another participant on a topic that we subscribe to.
struct OfferedWriter {
    Guid guid, participant;
    std::string topic;      ///< ROS name
    double seconds = 0.0;   ///< since it was discovered [s]
    bool matched = false;   ///< with a reader of ours
    bool steady = false;    ///< it offers best effort, as streams do and events do not
    bool received = false;  ///< a sample of it was received
};

/// What is announced in the domain, and what of it we receive.
struct DomainReception {
    struct Process {
        RemoteParticipant participant;
        double seconds = 0.0;  ///< since it was discovered [s]
    };
    std::vector<OfferedWriter> writers;
    std::vector<Process> mute;  ///< participants without any known reader or writer
};

/// Why one of our readers or writers does not exchange samples with a remote endpoint of its topic.
struct Mismatch {
    WireComplaint complaint;
    Guid remote;  ///< the other endpoint
};

}  // namespace leitstand
