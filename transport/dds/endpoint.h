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
    std::string name;      ///< name that it gave itself; "/" for ROS 2 nodes
    std::string host;      ///< its host name if it announces it, otherwise its first address, "192.168.0.7"
    bool refused = false;  ///< whether it could not prove an identity that we accept (DDS-Security)
};

/// A writer or reader of another participant.
struct RemoteEndpoint {
    enum class Kind : std::uint8_t { Writer, Reader };
    Kind kind = Kind::Writer;
    Guid guid, participant;
    std::string participantName, host;  ///< as in RemoteParticipant
    std::string topic;                  ///< ROS name "/kurt3d/odom" if it has one, otherwise the DDS name
    std::string type;      ///< ROS name "nav_msgs/msg/Odometry" if it has one, otherwise the DDS name
    bool ros = false;      ///< whether the topic belongs to ROS 2 ("rt/" on the network)
    bool keyed = false;    ///< whether its instances have keys; ROS 2 topics have none
    std::string typeHash;  ///< of its type, "RIHS01_..." (REP 2016); empty: not announced, as before Iron
    bool exclusiveOwnership = false;
    std::vector<std::string> partitions;  ///< empty: the default partition
    /// What it offers or requests. DDS does not announce the depth of the history, so it is always 1 here.
    /// Durabilities beyond transient local are reported as transient local.
    Qos qos;
};

/// A writer of another participant on a topic that we subscribe to.
struct OfferedWriter {
    Guid guid, participant;
    std::string topic;      ///< ROS name
    double seconds = 0.0;   ///< since it was discovered [s]
    bool matched = false;   ///< whether it matched one of our readers
    bool steady = false;    ///< whether it offers best effort, as streams do; events do not
    bool received = false;  ///< whether a sample from it was received
};

/// What is announced in the domain, and from which writers we receive samples.
struct DomainReception {
    struct Process {
        RemoteParticipant participant;
        double seconds = 0.0;  ///< since it was discovered [s]
    };
    std::vector<OfferedWriter> writers;
    std::vector<Process> mute;  ///< participants without any known reader or writer
};

/// Why one of our readers or writers exchanges no samples with a remote endpoint on its topic.
struct Mismatch {
    WireComplaint complaint;
    Guid remote;  ///< the other endpoint
};

}  // namespace leitstand
