#pragma once

#include <cstddef>
#include <functional>

namespace leitstand {

/// Returns the number of threads for a setting of @p threads: 0 is one per core.
[[nodiscard]] int threadCount(int threads);

/// Calls @p body(first, last) for the ranges [0, grain), [grain, 2 grain) ... below @p count, on up to
/// @p threads threads (0: one per core; 1: in order on the calling one). The ranges do not depend on the
/// number of threads: results kept by first / grain and joined in order do not either. Returns when all is
/// done; an exception of the body is passed on.
void parallelFor(std::size_t count, std::size_t grain, int threads,
                 const std::function<void(std::size_t first, std::size_t last)>& body);

/// Starts the threads that parallelFor() shares work with, unless they run already. A thread has the priority
/// of the one that starts it, so lower the priority of the calling thread before this call.
void beginSharedThreads();

}  // namespace leitstand
