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

/// The content of a text field in the log: a code with named values, `disk_filling minutes=12 rate=3.4`. A
/// value is in quotes if it is empty or contains a blank, a quote, = or a backslash: `note="no answer"`.
/// Within quotes, each quote and backslash has a backslash in front.
struct CodedText {
    std::string code;                                         ///< small letters, digits and _
    std::vector<std::pair<std::string, std::string>> values;  ///< names and texts, in order

    /// The text of the value @p name; empty if there is none.
    [[nodiscard]] std::optional<std::string> value(std::string_view name) const;
    /// The value @p name as a finite number; empty if there is no such value or it is not a number.
    [[nodiscard]] std::optional<double> figure(std::string_view name) const;
};

[[nodiscard]] std::string toString(const CodedText& coded);
/// Parses @p text; empty when any part of it does not have the form of CodedText. A single word is a code
/// without values.
[[nodiscard]] std::optional<CodedText> codedText(std::string_view text);

/// One of the things that text fields of the log may say, and the words for it.
struct LogPhrase {
    const char* code;   ///< "brake_passed"
    const char* words;  ///< in English, with "{}" for each value; translated when shown
    /// Names of the values, in the order of the "{}"; the rest are null.
    std::array<const char*, 4> names = {};
};

/// Returns the text of @p phrase for the log. @p values: one for each of the phrase's names, in their order.
template <class... Values>
[[nodiscard]] std::string logged(const LogPhrase& phrase, const Values&... values) {
    CodedText coded{phrase.code, {}};
    std::size_t i = 0;
    (coded.values.emplace_back(phrase.names.at(i++), fmt::format("{}", values)), ...);
    return toString(coded);
}

/// A phrase that was read from a text field of the log.
struct ReadPhrase {
    std::optional<LogPhrase> phrase = {};  ///< the known phrase; empty: the text is none
    std::vector<std::string> values = {};
};
/// Finds the one of @p known that @p text contains: by its code, or in logs older than the codes, by its
/// English sentence.
[[nodiscard]] ReadPhrase readPhrase(std::string_view text, std::span<const LogPhrase> known);
/// Returns @p read in the window's language, with its values. It must have a phrase. @p context: context of
/// the phrase's translation.
[[nodiscard]] std::string wordsOf(const char* context, const ReadPhrase& read);

}  // namespace leitstand
