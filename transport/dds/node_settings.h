#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace leitstand {

/// Which queue a publisher's samples go through on their way to the network.
enum class Flow : std::uint8_t {
    Immediate,  ///< sent by the thread that writes: commands, stops, pings
    Telemetry,  ///< small samples of steady streams
    Scans,
    Pictures,
};

/// At most @p bytes leave in each period; larger samples are cut into pieces of that size. A period begins
/// when the last one is over *and* the sending thread gets its turn. On a busy computer, short periods
/// stretch to a multiple, and the limit sinks with them.
struct FlowLimit {
    int bytes = 7000;       ///< [B]; 0: no limit
    int milliseconds = 10;  ///< length of the period
};

/// Files of DDS-Security 1.1 (PEM certificates and key; governance and permissions signed as S/MIME).
struct SecurityFiles {
    std::filesystem::path identityCa = {};     ///< certificate of the authority that signed all identities
    std::filesystem::path certificate = {};    ///< this participant's
    std::filesystem::path privateKey = {};     ///< this participant's
    std::filesystem::path permissionsCa = {};  ///< empty: the identity authority signs permissions too
    std::filesystem::path governance = {};     ///< .p7s
    std::filesystem::path permissions = {};    ///< .p7s
};

/// How a process takes part in a domain.
struct NodeSettings {
    int domain = 0;                  ///< 0..232
    std::string name = "leitstand";  ///< what others see as the participant's name
    /// Names ("wlan0") or IPv4 addresses of the interfaces to use; empty: all.
    std::vector<std::string> interfaces = {};
    /// Peers that we announce ourselves to by unicast: "192.168.0.7" (the first ten participants there) or
    /// "192.168.0.7:7410" (one of them).
    std::vector<std::string> initialPeers = {};
    bool multicast = true;  ///< false: discovery by initial peers or server only, nothing is sent to groups
    /// Discovery servers as in ROS_DISCOVERY_SERVER: "192.168.0.1:11811;192.168.0.2"; the place in the list
    /// is the server's number, empty places are skipped. Empty: peers discover each other.
    std::string discoveryServer = {};
    /// XML profiles replace our participant defaults when FASTRTPS_DEFAULT_PROFILES_FILE (in Fast DDS 3:
    /// FASTDDS_DEFAULT_PROFILES_FILE) names a file. Profiles named after a topic ("/kurt3d/points" or
    /// "rt/kurt3d/points") replace the QoS of its readers and writers.
    bool useXmlProfiles = true;
    std::optional<SecurityFiles> security = {};  ///< none: open to everyone in the domain
    /// The others forget a participant that was silent for so long [s]. After a shorter radio gap, missed
    /// samples arrive as far as the writers' histories reach. After a longer gap, only transient local
    /// samples arrive: a gap of 30 s with a lease of 20 s costs every volatile sample in it. A participant
    /// that ends in order is forgotten at once. Silence shows earlier than after the lease, by the data that
    /// is missing.
    double lease = 100.0;
    /// Set for a link of 10 Mbit/s that two robots share: the delay of odometry and commands stays below
    /// 60 ms (99th percentile) beside scans and pictures. Nothing is limited when all interfaces are
    /// loopback. With security on, pieces are 7500 B at least. Fast DDS 3.1 cannot limit flows: there, the
    /// bytes of `scanLimit` only bound the size of messages.
    FlowLimit telemetryLimit = {7000, 10}, scanLimit = {7000, 20}, pictureLimit = {7000, 15};
};

}  // namespace leitstand
