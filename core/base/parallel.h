#pragma once

#include <cstddef>
#include <functional>

namespace leitstand {

/// Returns the number of threads for a setting of @p threads: 0 means one per core.
[[nodiscard]] int threadCount(int threads);

/// Calls @p body(first, last) for the ranges [0, grain), [grain, 2 grain) ... below @p count. Uses up to
/// @p threads threads (0: one per core; 1: in order on the calling thread). The ranges do not depend on the
/// number of threads. So neither do results that are stored by first / grain and joined in order. Returns
/// when all calls are done; an exception of @p body is passed on.
void parallelFor(std::size_t count, std::size_t grain, int threads,
                 const std::function<void(std::size_t first, std::size_t last)>& body);

/// Starts the threads that parallelFor() uses, if they do not run yet. Each gets the priority of the thread
/// that starts it, so lower the priority of the calling thread before this call.
void beginSharedThreads();

}  // namespace leitstand
