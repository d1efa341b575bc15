#include "core/base/parallel.h"

#include <algorithm>

#if defined(__SANITIZE_THREAD__)
#include <exception>
#include <thread>
#include <vector>
#else
#include <atomic>
#include <chrono>
#include <thread>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif
#include <tbb/info.h>

namespace leitstand {
namespace {

using Range = std::function<void(std::size_t)>;

#if defined(__SANITIZE_THREAD__)
// ThreadSanitizer does not see how the packaged oneTBB, which is built without it, hands work over, and
// reports every task. With threads of our own it checks what matters: the bodies. Ranges are dealt out
// beforehand, as a common counter would put the threads in an order that hides their races.
void runAll(std::size_t ranges, int threads, const Range& range) {
    const auto workers = static_cast<std::size_t>(threads);
    std::vector<std::exception_ptr> thrown(workers);
    const auto work = [&](std::size_t worker) {
        try {
            for (std::size_t i = worker; i < ranges; i += workers) range(i);
        } catch (...) {
            thrown[worker] = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> running;
        for (std::size_t worker = 0; worker < workers; ++worker) running.emplace_back(work, worker);
    }
    for (const std::exception_ptr& one : thrown) {
        if (one) std::rethrow_exception(one);
    }
}
void beginAll() {}  // there are no shared threads
#else
void runAll(std::size_t ranges, int threads, const Range& range) {
    // More threads than processors compute nothing sooner, and oneTBB complains about them.
    tbb::task_arena arena(std::min(threads, tbb::info::default_concurrency()));
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, ranges, range); });
}

/// oneTBB starts a thread when there is work for it: gives all threads work until all run, or for 200 ms.
void beginAll() {
    const int threads = tbb::info::default_concurrency();
    const auto soon = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    std::atomic<int> come = 0;
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_for(
            0, threads,
            [&](int) {
                ++come;
                while (come < threads && std::chrono::steady_clock::now() < soon) std::this_thread::yield();
            },
            tbb::simple_partitioner());
    });
}
#endif

}  // namespace

int threadCount(int threads) {
    return threads > 0 ? threads : std::max(1, tbb::info::default_concurrency());
}

void parallelFor(std::size_t count, std::size_t grain, int threads,
                 const std::function<void(std::size_t first, std::size_t last)>& body) {
    grain = std::max<std::size_t>(grain, 1);
    const std::size_t ranges = count / grain + (count % grain != 0 ? 1 : 0);
    const auto range = [&](std::size_t i) { body(i * grain, std::min(count, (i + 1) * grain)); };
    const int used = threadCount(threads);
    if (used == 1 || ranges < 2) {
        for (std::size_t i = 0; i < ranges; ++i) range(i);
        return;
    }
    runAll(ranges, used, range);
}

void beginSharedThreads() {
    beginAll();
}

}  // namespace leitstand
