#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

namespace leitstand::cli {

/// Prints @p text on stdout. All output of leitstandctl goes through this function, so that names chosen by
/// others cannot send control characters to the terminal (core/base/printable.h). Line ends are kept, so pass
/// such a name through printable() before you put it into a line.
void print(std::string_view text);
/// Prints @p text with @p arguments, also on stdout.
template <class... Arguments>
void print(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    print(std::string_view(fmt::format(text, std::forward<Arguments>(arguments)...)));
}

/// Prints "leitstandctl: TEXT" on stderr, on one line.
void printError(std::string_view text);

/// Returns @p json as printJson() prints it, with a line end. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);
/// Prints jsonText() on stdout.
void printJson(const nlohmann::ordered_json& json);

}  // namespace leitstand::cli
