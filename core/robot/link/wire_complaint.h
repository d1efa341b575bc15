#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace leitstand {

/// One reason why a reader and a writer of a topic exchange no samples: the writer's offer does not meet the
/// reader's request (DDS 1.4, section 2.2.3).
struct WireProblem {
    enum class Kind : std::uint8_t {
        OffersLess,       ///< `theirs`, `ours`: what is offered and requested, "best effort", "reliable"
        AsksMore,         ///< the same if the robot is the reader
        SendsOther,       ///< `theirs`, `ours`: the message types
        ExpectsOther,     ///< the same if the robot is the reader
        Keyed,            ///< the robot's topic has keys; ours has none, as in ROS 2
        OffersExclusive,  ///< the robot offers exclusive ownership; ours is shared, as in ROS 2
        AsksExclusive,
        Partition,    ///< `theirs`: the robot's partition, which is not the default one
        WritesXcdr2,  ///< the robot does not write XCDR1, which we need
        ReadsXcdr2,
        Liveliness,  ///< the robot requests a liveliness that we do not offer
        Security,    ///< permissions or governance of one side forbid the exchange
    };
    Kind kind = Kind::OffersLess;
    std::string theirs = {}, ours = {};  ///< their meaning depends on the kind; terms of DDS and ROS 2
    friend bool operator==(const WireProblem&, const WireProblem&) = default;
};

/// All problems between one of our readers or writers and one of a robot.
struct WireComplaint {
    std::string topic;  ///< ROS name
    std::vector<WireProblem> problems;
    friend bool operator==(const WireComplaint&, const WireComplaint&) = default;
};

/// Text for logs: "robot offers best effort, we asked for reliable".
[[nodiscard]] std::string toString(const WireProblem& problem);
/// "/kurt3d/odom: robot offers best effort, we asked for reliable"; several problems are joined by "; ".
[[nodiscard]] std::string toString(const WireComplaint& complaint);
/// The same text in the window's language.
[[nodiscard]] std::string worded(const WireComplaint& complaint);

}  // namespace leitstand
