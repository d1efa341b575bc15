#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include "core/base/heap.h"

namespace leitstand {

/// Returns free memory to the system at an interval, on its own thread. A station runs for hours: scans that
/// stay lie between slices, pictures and queues that go. Without this, a fifth of its memory would be free
/// after an hour but still held.
class HeapKeeper {
public:
    explicit HeapKeeper(std::chrono::milliseconds interval = std::chrono::seconds(20),
                        std::function<void()> work = &returnFreeHeap);
    ~HeapKeeper();  ///< does not wait for the interval
    HeapKeeper(const HeapKeeper&) = delete;
    HeapKeeper& operator=(const HeapKeeper&) = delete;

private:
    std::jthread m_thread;
};

}  // namespace leitstand
