#include "core/base/parallel.h"

#include <algorithm>

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace leitstand {

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
    tbb::task_arena arena(used);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, ranges, range); });
}

}  // namespace leitstand
