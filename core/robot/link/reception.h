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
    std::string process;    ///< text that identifies its process
    double seconds = 0.0;   ///< since it was discovered [s]
    bool received = false;  ///< whether a sample of this writer was received
};

/// A process that is announced in the domain, without any of its topics.
struct MuteProcess {
    std::string name;      ///< "kurt3d"
    double seconds = 0.0;  ///< since it was discovered [s]
};

/// What is announced in a domain, and which of its writers are received.
struct Announced {
    std::vector<AnnouncedWriter> writers;
    std::vector<MuteProcess> mute;
};

/// A robot is announced, but the station does not receive what it should from it.
struct ReceptionFault {
    enum class Kind : std::uint8_t {
        Mute,     ///< processes are announced, topics of the robot are not; names: those processes
        Silent,   ///< topics are announced, but no periodic sample comes; names: those topics
        Partial,  ///< periodic samples come, but never odometry or IMU; names: those topics
    };
    Kind kind = Kind::Silent;
    std::vector<std::string> names;
    double seconds = 0.0;  ///< Partial: since the newest of the topics was discovered [s]
};

/// Time within which an announced robot must be heard [s].
inline constexpr double ReceivedWithin = 2.0;
/// Time within which its odometry and IMU must be heard, while other streams are [s]: a sensor may start
/// slowly.
inline constexpr double TopicReceivedWithin = 5.0;

/// Returns what is not received of @p robot although it is announced; empty while nothing is announced, as
/// the robot is then absent. Only the robot's own streams that come several times a second count. Events,
/// answers to pings, gas, battery and diagnostics do not, as these may be rare. Processes that were heard
/// before the link (@p link) was lost are no such fault.
[[nodiscard]] std::optional<ReceptionFault> receptionFaultOf(const RobotDescription& robot, LinkState link,
                                                             const Announced& announced);
/// Whether a sample was received of any stream that receptionFaultOf() judges by.
[[nodiscard]] bool isReceived(const RobotDescription& robot, const Announced& announced);
/// Whether @p fault is over. Mute: @p link is up. Others: a sample was received on a topic that @p fault
/// names.
[[nodiscard]] bool isOver(const ReceptionFault& fault, LinkState link, const Announced& announced);

/// For logs: `announced_silent names="/kurt3d/odom, /kurt3d/points"`.
[[nodiscard]] std::string toString(const ReceptionFault& fault);
/// The same in the window's language.
[[nodiscard]] std::string worded(const ReceptionFault& fault);

/// Returns a text of toString() in the window's language; any other text stays as it is.
[[nodiscard]] std::string receptionText(const std::string& reported);

/// Decides when a station joins its domain again because a robot is announced but not heard. For a silent
/// robot: at once, after 5 s and after 15 s more; then the fault is the robot's, until it is heard. For
/// single topics: once each, and only soon after they were discovered, since the sensor may be off. Pure.
class RejoinPlan {
public:
    /// Whether to join again now. @p may: this station moves nothing and is stopping nothing.
    [[nodiscard]] bool isDue(const std::optional<ReceptionFault>& fault, bool may, SteadyTime now);
    /// Whether @p fault stays although everything was tried. True once for each robot until it is heard, and
    /// once for each topic.
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
