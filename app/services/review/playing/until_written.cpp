#include "app/services/review/playing/until_written.h"

#include <thread>

#include "core/base/words.h"

namespace leitstand {

Result<void> untilWritten(const std::function<bool()>& has, const std::function<std::string()>& problem,
                          std::chrono::nanoseconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    bool there = has();
    while (!there && std::chrono::steady_clock::now() < end) {
        std::this_thread::yield();
        there = has();
    }
    if (std::string text = problem(); !text.empty()) return Error{std::move(text)};
    if (there) return {};
    return Error{translate("leitstand::Station",
                           "the mission's log does not answer: it is not known whether this was written")};
}

}  // namespace leitstand
