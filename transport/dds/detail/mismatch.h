#pragma once

#include <vector>

#include "core/robot/link/wire_complaint.h"
#include "transport/dds/detail/local_endpoint.h"
#include "transport/dds/endpoint.h"

namespace leitstand::detail {

/// What discovery reports about a remote endpoint in addition to RemoteEndpoint, as far as matching depends
/// on it.
struct MatchTerms {
    bool xcdr1 = true;  ///< whether the remote writer or reader uses XCDR1, our representation
    /// Whether the remote reader accepts automatic liveliness without a lease.
    bool automaticLiveliness = true;
};

/// Returns why @p ours and @p theirs, endpoints on the same topic, do not match. Empty: nothing prevents a
/// match.
[[nodiscard]] std::vector<WireProblem> whyNoMatch(const LocalEndpoint& ours, const RemoteEndpoint& theirs,
                                                  const MatchTerms& terms);

}  // namespace leitstand::detail
