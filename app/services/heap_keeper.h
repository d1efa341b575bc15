#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include "core/base/heap.h"

namespace leitstand {

/// Gives free memory back from time to time, on a thread of its own. A station runs for hours: scans that
/// stay lie between slices, pictures and queues that go, and after an hour a fifth of its memory would be
/// free, but its own.
class HeapKeeper {
public:
    explicit HeapKeeper(std::chrono::milliseconds interval = std::chrono::seconds(20),
                        std::function<void()> work = &returnFreeHeap);
    ~HeapKeeper();  ///< waits for no interval
    HeapKeeper(const HeapKeeper&) = delete;
    HeapKeeper& operator=(const HeapKeeper&) = delete;

private:
    std::jthread m_thread;
};

}  // namespace leitstand
