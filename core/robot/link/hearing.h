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

/// A writer that the domain announces on a topic that the station listens to.
struct AnnouncedWriter {
    std::string topic;     ///< ROS name
    std::string process;   ///< whose it is: any text that tells processes apart
    double seconds = 0.0;  ///< since it was discovered [s]
    bool heard = false;    ///< a sample of it came
};

/// A process that is announced in the domain, but none of its topics.
struct MuteProcess {
    std::string name;      ///< "kurt3d"
    double seconds = 0.0;  ///< since it was discovered [s]
};

/// What is announced in a domain, and what of it comes.
struct Announced {
    std::vector<AnnouncedWriter> writers;
    std::vector<MuteProcess> mute;
};

/// A robot is announced, and the station does not hear of it what it should.
struct HearingFault {
    enum class Kind : std::uint8_t {
        Mute,     ///< processes are announced, topics of the robot are not; names: the processes'
        Silent,   ///< topics are announced, no periodic sample of any comes; names: the topics'
        Partial,  ///< periodic samples come, but never odometry or IMU; names: those topics'
    };
    Kind kind = Kind::Silent;
    std::vector<std::string> names;
    double seconds = 0.0;  ///< since the newest of them was discovered [s]
};

/// What is announced has so long until it is to be heard [s].
inline constexpr double HearWithin = 2.0;
/// ... and odometry and IMU, while others of the robot are heard [s]: a sensor may take a while to start.
inline constexpr double HearTopicWithin = 5.0;

/// What is not heard of @p robot although it is announced; empty while nothing is announced: then it is not
/// there. Judged by the streams that come several times a second and are the robot's own: streams on events
/// and answers to pings say nothing, and neither do gas, battery and diagnostics, which may be slow. A link
/// (@p link) that was heard and is lost is no such fault.
[[nodiscard]] std::optional<HearingFault> hearingFaultOf(const RobotDescription& robot, LinkState link,
                                                         const Announced& announced);
/// Whether a sample came of any stream that hearingFaultOf() judges by.
[[nodiscard]] bool isHeard(const RobotDescription& robot, const Announced& announced);
/// Whether @p fault is over, by what came since it was found.
[[nodiscard]] bool isOver(const HearingFault& fault, LinkState link, const Announced& announced);

/// For logs: "announced, but nothing comes: /kurt3d/odom, /kurt3d/points".
[[nodiscard]] std::string toString(const HearingFault& fault);
/// Likewise, in the window's language.
[[nodiscard]] std::string worded(const HearingFault& fault);

/// What toString() said, in the window's language; as it is where it is none of that.
[[nodiscard]] std::string hearingWorded(const std::string& said);

/// When a station joins its domain again because of a robot that is announced and not heard. Of a robot of
/// which nothing comes: at once, after 5 s and after 15 s more; then the fault is the robot's, until it was
/// heard once. For single topics: once each, and only soon after they were discovered, since it may be that
/// the sensor is off. Pure.
class RejoinPlan {
public:
    /// @p may: nothing moves by this station, and nothing is being stopped.
    [[nodiscard]] bool isDue(const std::optional<HearingFault>& fault, bool may, SteadyTime now);
    /// Whether @p fault stands although all was tried; true once for each robot until it was heard, and once
    /// for each topic.
    [[nodiscard]] bool hasFailed(const std::optional<HearingFault>& fault, SteadyTime now);
    /// A periodic sample of the robot came.
    void heard();

private:
    int m_tries = 0;
    bool m_failed = false;
    SteadyTime m_next = {};
    std::set<std::string> m_tried, m_failedTopics;
};

}  // namespace leitstand
