#pragma once

#include <optional>
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

/// A robot is announced, and the station hears nothing of it.
struct HearingFault {
    enum class Kind : std::uint8_t {
        Mute,    ///< processes are announced, topics of the robot are not; names: the processes'
        Silent,  ///< topics are announced, no sample comes; names: the topics'
    };
    Kind kind = Kind::Silent;
    std::vector<std::string> names;
    friend bool operator==(const HearingFault&, const HearingFault&) = default;
};

/// What is announced has so long until it is to be heard [s].
inline constexpr double HearWithin = 2.0;

/// Whether streams of @p role come at a rate, so that silence is a fault: events and commands do not.
[[nodiscard]] bool comesSteadily(StreamRole role);

/// Why nothing is heard of @p robot although it is announced; empty while its link (@p link) has anything,
/// and while nothing is announced: then it is not there. Judged by the streams that come several times a
/// second and are the robot's own; streams on events say nothing, and neither do gas, battery and
/// diagnostics, which may be slow.
[[nodiscard]] std::optional<HearingFault> hearingFaultOf(const RobotDescription& robot, LinkState link,
                                                         const Announced& announced);

/// For logs: "announced for 2 s and more, but nothing comes: /kurt3d/odom, /kurt3d/points".
[[nodiscard]] std::string toString(const HearingFault& fault);
/// Likewise, in the window's language.
[[nodiscard]] std::string worded(const HearingFault& fault);

/// What toString() said, in the window's language; as it is where it is none of that.
[[nodiscard]] std::string hearingWorded(const std::string& said);

/// When a station joins its domain anew because nothing is heard of a robot that is announced: at once, after
/// 5 s and after 15 s more; then the fault is the robot's, until it was heard once. Pure.
class RejoinPlan {
public:
    /// @p fault: it is announced and not heard; @p may: nothing moves by this station, and nothing is being
    /// stopped.
    [[nodiscard]] bool isDue(bool fault, bool may, SteadyTime now);
    void heard() { m_tries = 0; }

private:
    int m_tries = 0;
    SteadyTime m_next = {};
};

}  // namespace leitstand
