#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// How codes that are tags of victims begin and end; * stands for anything, ? for a character, # for a digit.
using TagPatterns = std::vector<std::string>;

/// Those of the generated arenas: V-01.
[[nodiscard]] inline TagPatterns usualTags() {
    return {"V-#*"};
}

/// Whether a code that says @p text is the tag of a victim. An empty one never is.
[[nodiscard]] bool isVictimTag(std::string_view text, const TagPatterns& patterns);

}  // namespace leitstand
