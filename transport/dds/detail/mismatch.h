#pragma once

#include <vector>

#include "core/robot/link/wire_complaint.h"
#include "transport/dds/detail/local_endpoint.h"
#include "transport/dds/endpoint.h"

namespace leitstand::detail {

/// What discovery tells beyond RemoteEndpoint and decides about a match.
struct MatchTerms {
    bool xcdr1 = true;                ///< a writer that writes (a reader that reads) our representation
    bool automaticLiveliness = true;  ///< a reader that is content with participants that tell they live
};

/// Why @p ours and @p theirs, of one topic, do not match; empty when nothing stands against it.
[[nodiscard]] std::vector<WireProblem> whyNoMatch(const LocalEndpoint& ours, const RemoteEndpoint& theirs,
                                                  const MatchTerms& terms);

}  // namespace leitstand::detail
