#pragma once

#include <vector>

#include "core/robot/link/wire_complaint.h"
#include "transport/dds/detail/local_endpoint.h"
#include "transport/dds/endpoint.h"

namespace leitstand::detail {

/// Terms of a match that discovery reports beyond RemoteEndpoint.
struct MatchTerms {
    bool xcdr1 = true;                ///< the writer writes (the reader reads) our representation
    bool automaticLiveliness = true;  ///< the reader accepts automatic liveliness without a lease
};

/// Returns why @p ours and @p theirs, of one topic, do not match; empty when nothing prevents it.
[[nodiscard]] std::vector<WireProblem> whyNoMatch(const LocalEndpoint& ours, const RemoteEndpoint& theirs,
                                                  const MatchTerms& terms);

}  // namespace leitstand::detail
