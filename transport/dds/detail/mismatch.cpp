#include "transport/dds/detail/mismatch.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "transport/dds/names.h"

namespace leitstand::detail {
namespace {

std::string_view words(Qos::Reliability reliability) {
    return reliability == Qos::Reliability::Reliable ? "reliable" : "best effort";
}

std::string_view words(Qos::Durability durability) {
    return durability == Qos::Durability::TransientLocal ? "transient local" : "volatile";
}

std::string deadlineWords(double seconds) {
    return seconds > 0.0 ? fmt::format("a deadline of {:g} s", seconds) : "no deadline";
}

/// Offers meet requests: which side is which depends on who writes.
void compareQos(const Qos& offered, const Qos& asked, bool weRead, std::vector<std::string>& reasons) {
    const auto add = [&](std::string_view offer, std::string_view request) {
        reasons.push_back(weRead ? fmt::format("robot offers {}, we asked for {}", offer, request)
                                 : fmt::format("we offer {}, robot asks for {}", offer, request));
    };
    if (offered.reliability < asked.reliability) add(words(offered.reliability), words(asked.reliability));
    if (offered.durability < asked.durability) add(words(offered.durability), words(asked.durability));
    const bool late = asked.deadline > 0.0 && (offered.deadline <= 0.0 || offered.deadline > asked.deadline);
    if (late) add(deadlineWords(offered.deadline), deadlineWords(asked.deadline));
}

}  // namespace

std::optional<std::string> whyNoMatch(const LocalEndpoint& ours, const RemoteEndpoint& theirs,
                                      const MatchTerms& terms) {
    std::vector<std::string> reasons;
    const bool weRead = ours.kind == LocalEndpoint::Kind::Reader;
    if (const std::string expected = rosTypeOf(ours.ddsType); theirs.type != expected) {
        reasons.push_back(weRead ? fmt::format("robot sends {}, we expected {}", theirs.type, expected)
                                 : fmt::format("robot expects {}, we send {}", theirs.type, expected));
    }
    if (theirs.keyed) {
        reasons.emplace_back("robot's topic has keys, ours has none as in ROS 2");
    }
    compareQos(weRead ? theirs.qos : ours.qos, weRead ? ours.qos : theirs.qos, weRead, reasons);
    if (theirs.exclusiveOwnership) {
        reasons.push_back(fmt::format("robot {} exclusive ownership, we share as ROS 2 does",
                                      weRead ? "offers" : "asks for"));
    }
    const auto isDefault = [](const std::string& partition) { return partition.empty() || partition == "*"; };
    if (!theirs.partitions.empty() &&
        std::none_of(theirs.partitions.begin(), theirs.partitions.end(), isDefault)) {
        reasons.push_back(fmt::format("robot is in partition \"{}\", we are in the default one",
                                      fmt::join(theirs.partitions, "\", \"")));
    }
    if (!terms.xcdr1) {
        reasons.push_back(weRead ? "robot writes XCDR2 only, we read XCDR1"
                                 : "robot reads XCDR2 only, we write XCDR1");
    }
    if (!weRead && !terms.automaticLiveliness) {
        reasons.emplace_back("robot asks for a liveliness that we do not offer");
    }
    if (reasons.empty()) return std::nullopt;
    return fmt::format("{}", fmt::join(reasons, "; "));
}

}  // namespace leitstand::detail
