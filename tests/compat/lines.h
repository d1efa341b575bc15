#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace leitstand::test {

/// A file of tests/compat.
[[nodiscard]] std::filesystem::path compatFile(const std::string& name);

/// The lines of @p file, without empty ones and those that begin with "#"; throws where it cannot be read.
[[nodiscard]] std::vector<std::string> linesOf(const std::filesystem::path& file);

/// Lines of @p list, a file of tests/compat, that are not in @p found.
[[nodiscard]] std::vector<std::string> goneFrom(const std::string& list,
                                                const std::vector<std::string>& found);

}  // namespace leitstand::test
