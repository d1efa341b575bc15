#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// A writer that the domain announces on a topic to which the station listens.
struct AnnouncedWriter {
    std::string topic;      ///< ROS name
    std::string process;    ///< its process: any text that identifies it
    double seconds = 0.0;   ///< since it was discovered [s]
    bool received = false;  ///< a sample of it was received
};

/// A process that is announced in the domain, without any of its topics.
struct MuteProcess {
    std::string name;      ///< "kurt3d"
    double seconds = 0.0;  ///< since it was discovered [s]
};

/// What is announced in a domain, and what of it is heard.
struct Announced {
    std::vector<AnnouncedWriter> writers;
    std::vector<MuteProcess> mute;
};

/// A robot is announced, and the station does not receive from it what it should.
struct ReceptionFault {
    enum class Kind : std::uint8_t {
        Mute,     ///< processes are announced, topics of the robot are not; names: the processes'
        Silent,   ///< topics are announced, no periodic sample of any comes; names: the topics'
        Partial,  ///< periodic samples come, but never odometry or IMU; names: those topics'
    };
    Kind kind = Kind::Silent;
    std::vector<std::string> names;
    double seconds = 0.0;  ///< since the newest of them was discovered [s]
};

/// Time within which an announced robot must be heard [s].
inline constexpr double ReceivedWithin = 2.0;
/// ... and its odometry and IMU, while other streams are heard [s]: a sensor may start slowly.
inline constexpr double TopicReceivedWithin = 5.0;

/// Returns what is not heard of @p robot although it is announced; empty while nothing is announced, as it is
/// then absent. Judged by the robot's own streams that come several times a second. Streams on events and
/// answers to pings do not count, nor do gas, battery and diagnostics, which may be slow. A link (@p link)
/// that was heard and is lost is no such fault.
[[nodiscard]] std::optional<ReceptionFault> receptionFaultOf(const RobotDescription& robot, LinkState link,
                                                             const Announced& announced);
/// Whether a sample was received of any stream that receptionFaultOf() judges by.
[[nodiscard]] bool isReceived(const RobotDescription& robot, const Announced& announced);
/// Whether @p fault is over, by what was received since it was found.
[[nodiscard]] bool isOver(const ReceptionFault& fault, LinkState link, const Announced& announced);

/// For logs: `announced_silent names="/kurt3d/odom, /kurt3d/points"`.
[[nodiscard]] std::string toString(const ReceptionFault& fault);
/// The same in the window's language.
[[nodiscard]] std::string worded(const ReceptionFault& fault);

/// Returns a text of toString() in the window's language; any other text stays as it is.
[[nodiscard]] std::string receptionText(const std::string& reported);

/// Decides when a station joins its domain again because of a robot that is announced and not heard. For a
/// silent robot: at once, after 5 s and after 15 s more. Then the fault is the robot's, until it is heard
/// once. For single topics: once each, and only soon after they were discovered, since the sensor may be off.
/// Pure.
class RejoinPlan {
public:
    /// @p may: this station moves nothing and is stopping nothing.
    [[nodiscard]] bool isDue(const std::optional<ReceptionFault>& fault, bool may, SteadyTime now);
    /// Whether @p fault stays although all was tried. True once for each robot until it is heard, and once
    /// for each topic.
    [[nodiscard]] bool hasFailed(const std::optional<ReceptionFault>& fault, SteadyTime now);
    /// A periodic sample of the robot was received.
    void received();

private:
    int m_tries = 0;
    bool m_failed = false;
    SteadyTime m_next = {};
    std::set<std::string> m_tried, m_failedTopics;
};

}  // namespace leitstand
