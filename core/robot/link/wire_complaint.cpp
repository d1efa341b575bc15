#include "core/robot/link/wire_complaint.h"

#include "core/base/words.h"

namespace leitstand {
namespace {

/// "{0}" is theirs, "{1}" is ours.
const char* wordsOf(WireProblem::Kind kind) {
    using Kind = WireProblem::Kind;
    switch (kind) {
        case Kind::OffersLess:
            return translatable("leitstand::WireWords", "robot offers {0}, we asked for {1}");
        case Kind::AsksMore:
            return translatable("leitstand::WireWords", "we offer {1}, robot asks for {0}");
        case Kind::SendsOther:
            return translatable("leitstand::WireWords", "robot sends {0}, we expected {1}");
        case Kind::ExpectsOther:
            return translatable("leitstand::WireWords", "robot expects {0}, we send {1}");
        case Kind::Keyed:
            return translatable("leitstand::WireWords", "robot's topic has keys, ours has none as in ROS 2");
        case Kind::OffersExclusive:
            return translatable("leitstand::WireWords",
                                "robot offers exclusive ownership, we share as ROS 2 does");
        case Kind::AsksExclusive:
            return translatable("leitstand::WireWords",
                                "robot asks for exclusive ownership, we share as ROS 2 does");
        case Kind::Partition:
            return translatable("leitstand::WireWords",
                                "robot is in partition \"{0}\", we are in the default one");
        case Kind::WritesXcdr2:
            return translatable("leitstand::WireWords", "robot writes XCDR2 only, we read XCDR1");
        case Kind::ReadsXcdr2:
            return translatable("leitstand::WireWords", "robot reads XCDR2 only, we write XCDR1");
        case Kind::Liveliness:
            return translatable("leitstand::WireWords", "robot asks for a liveliness that we do not offer");
        case Kind::Security:
            return translatable("leitstand::WireWords",
                                "security: permissions or governance of one side do not let them talk");
    }
    return "";
}

template <class Words>
std::string joined(const WireComplaint& complaint, Words words) {
    std::string text = complaint.topic;
    const char* between = ": ";
    for (const WireProblem& problem : complaint.problems) {
        text += between + words(problem);
        between = "; ";
    }
    return text;
}

}  // namespace

std::string toString(const WireProblem& problem) {
    return leitstand::fill(wordsOf(problem.kind), problem.theirs, problem.ours);
}

std::string toString(const WireComplaint& complaint) {
    return joined(complaint, [](const WireProblem& problem) { return toString(problem); });
}

std::string worded(const WireComplaint& complaint) {
    return joined(complaint, [](const WireProblem& problem) {
        return leitstand::fill(translate("leitstand::WireWords", wordsOf(problem.kind)), problem.theirs,
                               problem.ours);
    });
}

}  // namespace leitstand
