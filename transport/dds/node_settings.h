#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace leitstand {

/// Which queue a publisher's samples pass through on their way to the network.
enum class Flow : std::uint8_t {
    Immediate,  ///< sent by the writing thread: commands, stops, pings
    Telemetry,  ///< small samples of steady streams
    Scans,
    Pictures,
};

/// At most @p bytes are sent in each period; larger samples are cut into pieces of that size. A period begins
/// when the previous one is over *and* the sending thread runs. On a busy computer, short periods become
/// several times as long, and the limit decreases accordingly.
struct FlowLimit {
    int bytes = 7000;       ///< bytes per period [B]; 0: no limit
    int milliseconds = 10;  ///< length of the period
};

/// Files of DDS-Security 1.1 (PEM certificates and key; governance and permissions signed as S/MIME).
struct SecurityFiles {
    std::filesystem::path identityCa = {};   ///< certificate of the authority that signed all identities
    std::filesystem::path certificate = {};  ///< certificate of this participant
    std::filesystem::path privateKey = {};   ///< private key of this participant
    /// Certificate of the authority that signed permissions; empty: the identity authority.
    std::filesystem::path permissionsCa = {};
    std::filesystem::path governance = {};   ///< signed file (.p7s)
    std::filesystem::path permissions = {};  ///< signed file (.p7s)
};

/// How a process takes part in a domain.
struct NodeSettings {
    int domain = 0;                  ///< 0..232
    std::string name = "leitstand";  ///< the participant's name for others
    /// Names ("wlan0") or IPv4 addresses of the interfaces to use; empty: all.
    std::vector<std::string> interfaces = {};
    /// Addresses to which we announce ourselves by unicast: "192.168.0.7" (the first ten participants there)
    /// or "192.168.0.7:7410" (one of them).
    std::vector<std::string> initialPeers = {};
    /// False: only initial peers or a server are used for discovery, and nothing is sent to multicast groups.
    bool multicast = true;
    /// Discovery servers as in ROS_DISCOVERY_SERVER: "192.168.0.1:11811;192.168.0.2". A server's number is
    /// its position in the list; empty positions are skipped. Empty: peers discover each other.
    std::string discoveryServer = {};
    /// Whether XML profiles replace our defaults for the participant, if FASTRTPS_DEFAULT_PROFILES_FILE (in
    /// Fast DDS 3: FASTDDS_DEFAULT_PROFILES_FILE) names a file. Profiles named after a topic
    /// ("/kurt3d/points" or "rt/kurt3d/points") replace the QoS of its readers and writers.
    bool useXmlProfiles = true;
    std::optional<SecurityFiles> security = {};  ///< empty: no security; everyone in the domain may take part
    /// Others forget a participant that was silent for this long [s]. After a shorter gap of the radio,
    /// missed samples arrive as far as the writers' histories reach. After a longer gap, only transient local
    /// samples arrive: a gap of 30 s with a lease of 20 s loses every volatile sample in it. A participant
    /// that leaves properly is forgotten at once. Silence is noticed earlier than the lease, by the data that
    /// is missing.
    double lease = 100.0;
    /// Values for a link of 10 Mbit/s that two robots share: odometry and commands are delayed by less than
    /// 60 ms (99th percentile) while scans and pictures are sent. Nothing is limited if all interfaces are
    /// loopback. With security, pieces have at least 7500 B. Fast DDS 3.1 cannot limit flows: there, the
    /// bytes of `scanLimit` only limit the size of messages.
    FlowLimit telemetryLimit = {7000, 10}, scanLimit = {7000, 20}, pictureLimit = {7000, 15};
};

}  // namespace leitstand
