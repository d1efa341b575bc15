#pragma once

#include <functional>
#include <stop_token>

namespace leitstand {

/// Reports the progress of a long piece of work, and carries the request to cancel it.
struct Progress {
    std::function<void(double fraction)> report;  ///< 0 to 1, called on the worker's thread; may be empty
    std::stop_token stop;                         ///< checked often enough to end within about 100 ms

    void done(double fraction) const {
        if (report) report(fraction);
    }
    [[nodiscard]] bool cancelled() const { return stop.stop_requested(); }
};

}  // namespace leitstand
