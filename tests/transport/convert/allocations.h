#pragma once

#include <atomic>
#include <cstddef>

namespace leitstand::test {

/// Bytes that this program asked of operator new since it was last set to 0.
extern std::atomic<std::size_t> allocatedBytes;

}  // namespace leitstand::test
