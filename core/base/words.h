#pragma once

#include <string>

#include <fmt/format.h>

namespace leitstand {

/// Returns the translation of @p text in @p context; both are as written in the program.
using Translator = std::string (*)(const char* context, const char* text);
/// Makes translate() use @p translator from now on. Null: nothing is translated. Any thread.
void setTranslator(Translator translator);

/// Returns @p text in the window's language, or unchanged without a translator (core and session have no Qt).
/// For operators, never for the log. Both arguments are literals, which lupdate reads. Any thread.
[[nodiscard]] std::string translate(const char* context, const char* text);

/// Marks @p text in a table for lupdate, with its @p context. Call translate() where the text is shown.
constexpr const char* translatable(const char* /*context*/, const char* text) {
    return text;
}

/// Returns @p words with @p arguments filled in by fmt::format; returns @p words unchanged when a translation
/// breaks the format.
template <class... Arguments>
[[nodiscard]] std::string fill(const std::string& words, const Arguments&... arguments) {
    try {
        return fmt::format(fmt::runtime(words), arguments...);
    } catch (const fmt::format_error&) {
        return words;
    }
}

}  // namespace leitstand
