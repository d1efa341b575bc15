#include "core/base/phrases/coded_text.h"

#include <algorithm>
#include <cstring>

#include "core/base/words.h"

namespace leitstand {
namespace {

bool isName(std::string_view text) {
    const auto fits = [](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    };
    return !text.empty() && std::all_of(text.begin(), text.end(), fits);
}

bool isPlain(std::string_view value) {
    return !value.empty() && value.find_first_of(" \"\\=") == std::string_view::npos;
}

/// Takes a value off the front of @p rest; empty when none is there.
std::optional<std::string> takeValue(std::string_view& rest) {
    std::string value;
    if (!rest.starts_with('"')) {
        value = rest.substr(0, rest.find(' '));
        rest.remove_prefix(value.size());
        return isPlain(value) ? std::optional(value) : std::nullopt;
    }
    for (std::size_t i = 1; i < rest.size(); ++i) {
        if (rest[i] == '"') {
            rest.remove_prefix(i + 1);
            return value;
        }
        if (rest[i] == '\\' && ++i == rest.size()) break;
        value += rest[i];
    }
    return std::nullopt;
}

/// The values of @p coded that @p phrase names, in its order; empty when one is missing.
std::optional<std::vector<std::string>> valuesOf(const LogPhrase& phrase, const CodedText& coded) {
    std::vector<std::string> values;
    for (const char* const name : phrase.names) {
        if (name == nullptr) break;
        auto value = coded.value(name);
        if (!value) return std::nullopt;
        values.push_back(std::move(*value));
    }
    return values;
}

}  // namespace

std::optional<std::string> CodedText::value(std::string_view name) const {
    const auto found =
        std::ranges::find(values, name, [](const auto& one) { return std::string_view(one.first); });
    return found == values.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> CodedText::figure(std::string_view name) const {
    const auto text = value(name);
    return text ? figureIn(*text) : std::nullopt;
}

std::string toString(const CodedText& coded) {
    std::string text = coded.code;
    for (const auto& [name, value] : coded.values) {
        text += " " + name + "=";
        if (isPlain(value)) {
            text += value;
            continue;
        }
        text += '"';
        for (const char c : value) {
            if (c == '"' || c == '\\') text += '\\';
            text += c;
        }
        text += '"';
    }
    return text;
}

std::optional<CodedText> codedText(std::string_view text) {
    CodedText coded{std::string(text.substr(0, text.find(' '))), {}};
    if (!isName(coded.code)) return std::nullopt;
    text.remove_prefix(coded.code.size());
    while (text.starts_with(' ')) {
        text.remove_prefix(1);
        const std::string name(text.substr(0, text.find('=')));
        if (!isName(name) || name.size() == text.size()) return std::nullopt;
        text.remove_prefix(name.size() + 1);
        auto value = takeValue(text);
        if (!value) return std::nullopt;
        coded.values.emplace_back(name, std::move(*value));
    }
    return text.empty() ? std::optional(std::move(coded)) : std::nullopt;
}

ReadPhrase readPhrase(std::string_view text, std::span<const LogPhrase> known) {
    if (const auto coded = codedText(text)) {
        for (const LogPhrase& one : known) {
            if (coded->code != one.code) continue;
            if (auto values = valuesOf(one, *coded)) return {one, std::move(*values)};
        }
    }
    std::vector<const char*> sentences;
    for (const LogPhrase& one : known) sentences.push_back(one.words);
    KnownSentence old = knownSentence(text, sentences);
    if (old.words == nullptr) return {};
    const auto row = std::ranges::find(known, old.words, &LogPhrase::words);
    return {*row, std::move(old.values)};
}

std::string wordsOf(const char* context, const ReadPhrase& read) {
    return withValues(translate(context, read.phrase->words), read.values);
}

}  // namespace leitstand
