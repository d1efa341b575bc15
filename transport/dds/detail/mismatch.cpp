#include "transport/dds/detail/mismatch.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "transport/dds/names.h"

namespace leitstand::detail {
namespace {

std::string words(Qos::Reliability reliability) {
    return reliability == Qos::Reliability::Reliable ? "reliable" : "best effort";
}

std::string words(Qos::Durability durability) {
    return durability == Qos::Durability::TransientLocal ? "transient local" : "volatile";
}

std::string deadlineWords(double seconds) {
    return seconds > 0.0 ? fmt::format("a deadline of {:g} s", seconds) : "no deadline";
}

using Problems = std::vector<WireProblem>;
using Kind = WireProblem::Kind;

/// Compares what the writer offers with what the reader asks for. @p weRead: we are the reader.
void compareQos(const Qos& offered, const Qos& asked, bool weRead, Problems& problems) {
    const auto add = [&](std::string offer, std::string request) {
        problems.push_back(weRead ? WireProblem{Kind::OffersLess, std::move(offer), std::move(request)}
                                  : WireProblem{Kind::AsksMore, std::move(request), std::move(offer)});
    };
    if (offered.reliability < asked.reliability) add(words(offered.reliability), words(asked.reliability));
    if (offered.durability < asked.durability) add(words(offered.durability), words(asked.durability));
    const bool late = asked.deadline > 0.0 && (offered.deadline <= 0.0 || offered.deadline > asked.deadline);
    if (late) add(deadlineWords(offered.deadline), deadlineWords(asked.deadline));
}

}  // namespace

Problems whyNoMatch(const LocalEndpoint& ours, const RemoteEndpoint& theirs, const MatchTerms& terms) {
    Problems problems;
    const bool weRead = ours.kind == LocalEndpoint::Kind::Reader;
    if (const std::string expected = rosTypeOf(ours.ddsType); theirs.type != expected)
        problems.push_back({weRead ? Kind::SendsOther : Kind::ExpectsOther, theirs.type, expected});
    if (theirs.keyed) problems.push_back({Kind::Keyed});
    compareQos(weRead ? theirs.qos : ours.qos, weRead ? ours.qos : theirs.qos, weRead, problems);
    if (theirs.exclusiveOwnership) problems.push_back({weRead ? Kind::OffersExclusive : Kind::AsksExclusive});
    const auto isDefault = [](const std::string& partition) { return partition.empty() || partition == "*"; };
    if (!theirs.partitions.empty() &&
        std::none_of(theirs.partitions.begin(), theirs.partitions.end(), isDefault)) {
        problems.push_back({Kind::Partition, fmt::format("{}", fmt::join(theirs.partitions, "\", \"")), {}});
    }
    if (!terms.xcdr1) problems.push_back({weRead ? Kind::WritesXcdr2 : Kind::ReadsXcdr2});
    if (!weRead && !terms.automaticLiveliness) problems.push_back({Kind::Liveliness});
    return problems;
}

}  // namespace leitstand::detail
