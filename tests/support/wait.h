#pragma once

#include <chrono>
#include <thread>

namespace leitstand::test {

/// Waits until @p condition holds, looking every 2 ms; false when it still does not after @p atMost.
template <class Condition>
[[nodiscard]] bool waitUntil(Condition condition,
                             std::chrono::milliseconds atMost = std::chrono::seconds(20)) {
    const auto end = std::chrono::steady_clock::now() + atMost;
    while (!condition()) {
        if (std::chrono::steady_clock::now() >= end) return condition();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

}  // namespace leitstand::test
