#include "app/services/heap_keeper.h"

#include <condition_variable>
#include <mutex>
#include <utility>

namespace leitstand {

HeapKeeper::HeapKeeper(std::chrono::milliseconds interval, std::function<void()> work)
    : m_thread([interval, work = std::move(work)](const std::stop_token& stop) {
          std::mutex mutex;
          std::condition_variable_any stopped;
          std::unique_lock lock(mutex);
          while (!stop.stop_requested()) {
              stopped.wait_for(lock, stop, interval, [] { return false; });
              if (!stop.stop_requested()) work();
          }
      }) {}

HeapKeeper::~HeapKeeper() = default;

}  // namespace leitstand
