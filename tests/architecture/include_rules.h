#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace leitstand::test {

/// What is wrong with the includes of the source text @p text standing at @p path (relative to the checkout,
/// with slashes), after the table of design section 2; one line for each, empty when all is well. A file in a
/// folder that the table does not know is a violation too.
[[nodiscard]] std::vector<std::string> includeViolations(std::string_view path, std::string_view text);

}  // namespace leitstand::test
