#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include "core/base/heap.h"

namespace leitstand {

/// Returns free memory to the system at an interval, on its own thread. In a station's heap, scans that are
/// kept lie between slices, pictures and queues that are freed. Without this, a fifth of its memory would be
/// free but still held after an hour.
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
