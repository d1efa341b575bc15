#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/phrases/known_sentence.h"

namespace leitstand {

/// What a text field of the log says: a code with named values, `disk_filling minutes=12 rate=3.4`. A value
/// stands in quotes when it is empty or contains a blank, a quote, = or a backslash: `note="no answer"`.
/// Within quotes, a backslash stands before each quote and backslash.
struct CodedText {
    std::string code;                                         ///< small letters, digits and _
    std::vector<std::pair<std::string, std::string>> values;  ///< name and text, in order

    /// The text of the value @p name; empty if there is none.
    [[nodiscard]] std::optional<std::string> value(std::string_view name) const;
    /// The value @p name as a finite number; empty if there is no such value or it is not a number.
    [[nodiscard]] std::optional<double> figure(std::string_view name) const;
};

[[nodiscard]] std::string toString(const CodedText& coded);
/// Reads @p text; empty when any part of it is not of the form of CodedText. A single word is a code without
/// values.
[[nodiscard]] std::optional<CodedText> codedText(std::string_view text);

/// One thing that text fields of the log may say, and the words for it.
struct LogPhrase {
    const char* code;                       ///< "brake_passed"
    const char* words;                      ///< in English, with "{}" for each value; translated where shown
    std::array<const char*, 4> names = {};  ///< of the values, in the order of the "{}"; the rest are null
};

/// Returns the log's text for @p phrase. @p values: one for each of the phrase's names, in their order.
template <class... Values>
[[nodiscard]] std::string logged(const LogPhrase& phrase, const Values&... values) {
    CodedText coded{phrase.code, {}};
    std::size_t i = 0;
    (coded.values.emplace_back(phrase.names.at(i++), fmt::format("{}", values)), ...);
    return toString(coded);
}

/// A phrase that was read from a text field of the log.
struct ReadPhrase {
    std::optional<LogPhrase> phrase = {};  ///< the known phrase; empty: the text holds none
    std::vector<std::string> values = {};
};
/// Finds the phrase of @p known that @p text holds: by its code, or, in logs older than the codes, by its
/// English sentence.
[[nodiscard]] ReadPhrase readPhrase(std::string_view text, std::span<const LogPhrase> known);
/// Returns the words of @p read in the window's language, with the values filled in. @p read must hold a
/// phrase; @p context: of the phrase's translation.
[[nodiscard]] std::string wordsOf(const char* context, const ReadPhrase& read);

}  // namespace leitstand
