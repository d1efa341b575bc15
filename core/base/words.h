#pragma once

#include <string>

#include <fmt/format.h>

namespace leitstand {

/// What finds the translation of @p text in @p context; both as they are written in the program.
using Translator = std::string (*)(const char* context, const char* text);
/// From now on translate() asks @p translator; null: nothing is translated. Any thread.
void setTranslator(Translator translator);

/// Words for operators in the window's language, where there is a window: what core and session say has no
/// Qt. Both arguments are literals, which lupdate reads. Never for what goes into the log. Any thread.
[[nodiscard]] std::string translate(const char* context, const char* text);

/// @p text of a table: lupdate reads it with its @p context, and translate() is called where it is shown.
constexpr const char* translatable(const char* /*context*/, const char* text) {
    return text;
}

/// @p words with what is to be filled in, as of fmt::format; as they are when a translation has it wrong.
template <class... Arguments>
[[nodiscard]] std::string fill(const std::string& words, const Arguments&... arguments) {
    try {
        return fmt::format(fmt::runtime(words), arguments...);
    } catch (const fmt::format_error&) {
        return words;
    }
}

}  // namespace leitstand
