#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// Patterns for the texts of codes that are victim tags: * matches any text, ? one character, # one digit.
using TagPatterns = std::vector<std::string>;

/// Returns the patterns for the generated arenas, with tags such as V-01.
[[nodiscard]] inline TagPatterns usualTags() {
    return {"V-#*"};
}

/// Whether a code with @p text is the tag of a victim. An empty text never is.
[[nodiscard]] bool isVictimTag(std::string_view text, const TagPatterns& patterns);

}  // namespace leitstand
