#include "core/mission/finds/victim_tags.h"

#include <algorithm>
#include <cstddef>

namespace leitstand {
namespace {

bool fits(char pattern, char one) {
    return pattern == '?' || pattern == one || (pattern == '#' && one >= '0' && one <= '9');
}

/// Without recursion, because the text of a code may be long and come from anybody.
bool matches(std::string_view pattern, std::string_view text) {
    std::size_t p = 0, t = 0, star = std::string_view::npos, resume = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = t;
        } else if (p < pattern.size() && fits(pattern[p], text[t])) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++resume;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace

bool isVictimTag(std::string_view text, const TagPatterns& patterns) {
    return !text.empty() && std::any_of(patterns.begin(), patterns.end(),
                                        [&](const std::string& pattern) { return matches(pattern, text); });
}

}  // namespace leitstand
