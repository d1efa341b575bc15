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

/// A DDS writer that is announced in the domain, on a topic that the station reads.
struct AnnouncedWriter {
    std::string topic;      ///< ROS name
    std::string process;    ///< text that identifies its process
    double seconds = 0.0;   ///< since it was discovered [s]
    bool received = false;  ///< whether a sample from this writer was received
};

/// A process that is announced in the domain without any of its topics.
struct MuteProcess {
    std::string name;      ///< "kurt3d"
    double seconds = 0.0;  ///< since it was discovered [s]
};

/// What is announced in a domain, and from which writers samples were received.
struct Announced {
    std::vector<AnnouncedWriter> writers;
    std::vector<MuteProcess> mute;
};

/// A robot is announced, but the station does not receive what it should from it.
struct ReceptionFault {
    enum class Kind : std::uint8_t {
        Mute,     ///< processes of the robot are announced, but not its topics; `names` has those processes
        Silent,   ///< topics are announced, but no periodic sample arrives; `names` has those topics
        Partial,  ///< periodic samples arrive, but never odometry or IMU; `names` has those topics
    };
    Kind kind = Kind::Silent;
    std::vector<std::string> names;
    double seconds = 0.0;  ///< for Partial: since the newest of these topics was discovered [s]
};

/// A robot must be received within this time after it is announced [s].
inline constexpr double ReceivedWithin = 2.0;
/// Odometry and IMU must be received within this time if other streams are [s], since a sensor may start
/// slowly.
inline constexpr double TopicReceivedWithin = 5.0;

/// Returns what is not received from @p robot although it is announced. Empty while nothing is announced:
/// then the robot is absent. Only streams of this robot alone that come several times a second are checked.
/// Events, answers to pings, gas, battery and diagnostics may be rare and are not. Processes that were
/// received before the link (@p link) was lost are no such fault.
[[nodiscard]] std::optional<ReceptionFault> receptionFaultOf(const RobotDescription& robot, LinkState link,
                                                             const Announced& announced);
/// Whether a sample was received on any stream that receptionFaultOf() checks.
[[nodiscard]] bool isReceived(const RobotDescription& robot, const Announced& announced);
/// Whether @p fault has ended. Mute: @p link is up. Others: a sample was received on a topic in the fault's
/// names.
[[nodiscard]] bool isOver(const ReceptionFault& fault, LinkState link, const Announced& announced);

/// Text for logs: `announced_silent names="/kurt3d/odom, /kurt3d/points"`.
[[nodiscard]] std::string toString(const ReceptionFault& fault);
/// The same text in the window's language.
[[nodiscard]] std::string worded(const ReceptionFault& fault);

/// Returns a text of toString() in the window's language. Any other text is not changed.
[[nodiscard]] std::string receptionText(const std::string& reported);

/// Decides when a station joins its domain again, because a robot is announced but not received. If the whole
/// robot is silent: at once, after 5 s, and after 15 s more. After that the fault is assumed to be the
/// robot's, until it is received. For single topics: once each, and only soon after they were discovered,
/// since the sensor may be off. Pure.
class RejoinPlan {
public:
    /// Whether to join again now. @p may: whether this is allowed, because the station moves or stops no
    /// robot.
    [[nodiscard]] bool isDue(const std::optional<ReceptionFault>& fault, bool may, SteadyTime now);
    /// Whether @p fault remains after everything was tried. True once for each robot until it is received,
    /// and once for each topic.
    [[nodiscard]] bool hasFailed(const std::optional<ReceptionFault>& fault, SteadyTime now);
    /// Call when a periodic sample of the robot was received.
    void received();

private:
    int m_tries = 0;
    bool m_failed = false;
    SteadyTime m_next = {};
    std::set<std::string> m_tried, m_failedTopics;
};

}  // namespace leitstand
