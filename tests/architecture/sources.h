#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace leitstand::test {

/// All our sources below these folders of the checkout, as paths relative to it, sorted.
[[nodiscard]] std::vector<std::string> sources(std::initializer_list<const char*> folders);
/// Text of such a source.
[[nodiscard]] std::string content(const std::string& source);

}  // namespace leitstand::test
