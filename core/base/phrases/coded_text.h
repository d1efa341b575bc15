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
/// with blanks, or one that is empty, stands in quotes: `note="no answer"`; in those, \ stands before " and
/// \.
struct CodedText {
    std::string code;                                         ///< small letters, digits and _
    std::vector<std::pair<std::string, std::string>> values;  ///< name and text, in order

    /// The text of the value @p name; empty if there is none.
    [[nodiscard]] std::optional<std::string> value(std::string_view name) const;
    /// The same as a finite number; empty if it is none.
    [[nodiscard]] std::optional<double> figure(std::string_view name) const;
};

[[nodiscard]] std::string toString(const CodedText& coded);
/// Reads @p text; empty when it is not wholly of that form. A single word is a code without values.
[[nodiscard]] std::optional<CodedText> codedText(std::string_view text);

/// One thing that text fields of the log may say, and the words for it.
struct LogPhrase {
    const char* code;                       ///< "brake_passed"
    const char* words;                      ///< in English, with "{}" for each value; translated where shown
    std::array<const char*, 4> names = {};  ///< of the values, in the order of the "{}"; the rest are null
};

/// Returns what the log holds for @p phrase with @p values, which are one for each of its names.
template <class... Values>
[[nodiscard]] std::string logged(const LogPhrase& phrase, const Values&... values) {
    CodedText coded{phrase.code, {}};
    std::size_t i = 0;
    (coded.values.emplace_back(phrase.names.at(i++), fmt::format("{}", values)), ...);
    return toString(coded);
}

/// A phrase as it was read.
struct ReadPhrase {
    std::optional<LogPhrase> phrase = {};  ///< one of the known; empty: none
    std::vector<std::string> values = {};
};
/// Returns which of @p known @p text is: by its code, or, in logs from before there were codes, by its
/// English sentence.
[[nodiscard]] ReadPhrase readPhrase(std::string_view text, std::span<const LogPhrase> known);
/// Returns the words of @p read in the window's language (@p context of its translation), with its values.
[[nodiscard]] std::string wordsOf(const char* context, const ReadPhrase& read);

}  // namespace leitstand
