#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace leitstand {

/// Divides the indices 0 to @p count - 1 into connected groups. @p far(a, b) returns whether b is too far
/// from a to belong to the same thing.
template <class Far>
[[nodiscard]] std::vector<std::vector<std::size_t>> grouped(std::size_t count, const Far& far) {
    std::vector<std::vector<std::size_t>> found;
    std::vector<std::size_t> left(count);
    for (std::size_t i = 0; i < count; ++i) left[i] = i;
    while (!left.empty()) {
        std::vector<std::size_t> thing = {left.back()};
        left.pop_back();
        for (std::size_t next = 0; next < thing.size(); ++next) {
            const std::size_t here = thing[next];
            const auto near =
                std::partition(left.begin(), left.end(), [&](std::size_t other) { return far(here, other); });
            thing.insert(thing.end(), near, left.end());
            left.erase(near, left.end());
        }
        found.push_back(std::move(thing));
    }
    return found;
}

}  // namespace leitstand
