#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace leitstand {

/// One reason why a reader and a writer of a topic do not exchange samples (DDS 1.4, section 2.2.3: offers of
/// a writer meet requests of a reader).
struct WireProblem {
    enum class Kind : std::uint8_t {
        OffersLess,       ///< theirs, ours: what is offered and requested, "best effort", "reliable"
        AsksMore,         ///< the same, but the robot reads
        SendsOther,       ///< theirs, ours: the message types
        ExpectsOther,     ///< the same, but the robot reads
        Keyed,            ///< the robot's topic has keys, ours has none as in ROS 2
        OffersExclusive,  ///< ownership; we share as ROS 2 does
        AsksExclusive,
        Partition,    ///< theirs: the robot's partition, which is not the default one
        WritesXcdr2,  ///< the robot writes no XCDR1, which we read
        ReadsXcdr2,
        Liveliness,  ///< the robot requests a liveliness that we do not offer
        Security,    ///< permissions or governance of one side do not let them talk
    };
    Kind kind = Kind::OffersLess;
    std::string theirs = {}, ours = {};  ///< meaning by kind; terms of DDS and ROS 2
    friend bool operator==(const WireProblem&, const WireProblem&) = default;
};

/// All problems between our reader or writer and one of a robot.
struct WireComplaint {
    std::string topic;  ///< ROS name
    std::vector<WireProblem> problems;
    friend bool operator==(const WireComplaint&, const WireComplaint&) = default;
};

/// For logs: "robot offers best effort, we asked for reliable".
[[nodiscard]] std::string toString(const WireProblem& problem);
/// "/kurt3d/odom: robot offers best effort, we asked for reliable", several joined by "; ".
[[nodiscard]] std::string toString(const WireComplaint& complaint);
/// The same in the window's language.
[[nodiscard]] std::string worded(const WireComplaint& complaint);

}  // namespace leitstand
