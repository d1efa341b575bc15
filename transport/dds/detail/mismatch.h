#pragma once

#include <vector>

#include "core/robot/link/wire_complaint.h"
#include "transport/dds/detail/local_endpoint.h"
#include "transport/dds/endpoint.h"

namespace leitstand::detail {

/// What discovery reports of a remote endpoint beyond RemoteEndpoint, as far as it decides on a match.
struct MatchTerms {
    bool xcdr1 = true;                ///< the remote writer or reader uses XCDR1, our representation
    bool automaticLiveliness = true;  ///< the remote reader accepts automatic liveliness without a lease
};

/// Returns why @p ours and @p theirs, endpoints of the same topic, do not match. Empty: nothing prevents a
/// match.
[[nodiscard]] std::vector<WireProblem> whyNoMatch(const LocalEndpoint& ours, const RemoteEndpoint& theirs,
                                                  const MatchTerms& terms);

}  // namespace leitstand::detail
