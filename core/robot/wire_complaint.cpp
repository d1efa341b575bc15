#include "core/robot/wire_complaint.h"

#include <fmt/format.h>

namespace leitstand {

std::string toString(const WireProblem& problem) {
    using Kind = WireProblem::Kind;
    switch (problem.kind) {
        case Kind::OffersLess:
            return fmt::format("robot offers {}, we asked for {}", problem.theirs, problem.ours);
        case Kind::AsksMore:
            return fmt::format("we offer {}, robot asks for {}", problem.ours, problem.theirs);
        case Kind::SendsOther:
            return fmt::format("robot sends {}, we expected {}", problem.theirs, problem.ours);
        case Kind::ExpectsOther:
            return fmt::format("robot expects {}, we send {}", problem.theirs, problem.ours);
        case Kind::Keyed:
            return "robot's topic has keys, ours has none as in ROS 2";
        case Kind::OffersExclusive:
            return "robot offers exclusive ownership, we share as ROS 2 does";
        case Kind::AsksExclusive:
            return "robot asks for exclusive ownership, we share as ROS 2 does";
        case Kind::Partition:
            return fmt::format("robot is in partition \"{}\", we are in the default one", problem.theirs);
        case Kind::WritesXcdr2:
            return "robot writes XCDR2 only, we read XCDR1";
        case Kind::ReadsXcdr2:
            return "robot reads XCDR2 only, we write XCDR1";
        case Kind::Liveliness:
            return "robot asks for a liveliness that we do not offer";
        case Kind::Security:
            return "security: permissions or governance of one side do not let them talk";
    }
    return {};
}

std::string toString(const WireComplaint& complaint) {
    std::string text = complaint.topic;
    const char* between = ": ";
    for (const WireProblem& problem : complaint.problems) {
        text += between + toString(problem);
        between = "; ";
    }
    return text;
}

}  // namespace leitstand
