#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

namespace leitstand::cli {

/// Prints @p text on stdout: all that leitstandctl says goes through here, so that no name that others chose
/// reaches a terminal as it is (core/base/printable.h). Lines stay lines; a name of others is made
/// printable() before it stands in one.
void print(std::string_view text);
/// The same with arguments.
template <class... Arguments>
void print(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    print(std::string_view(fmt::format(text, std::forward<Arguments>(arguments)...)));
}

/// Prints "leitstandctl: TEXT" on stderr, as one line.
void printError(std::string_view text);

/// @p json as it is printed, with a line end. What is no UTF-8 in it becomes U+FFFD.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);
/// Prints jsonText().
void printJson(const nlohmann::ordered_json& json);

}  // namespace leitstand::cli
