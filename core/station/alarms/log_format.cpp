#include "core/station/alarms/log_format.h"

#include <algorithm>
#include <array>
#include <utility>

namespace leitstand::log_format {

ReadPhrase newsIn(std::string_view text) {
    ReadPhrase news;
    if (codedText(text)) {
        news = readPhrase(text, All);
    } else {  // old logs named the file first
        std::array<const char*, All.size()> sentences{};
        std::ranges::transform(All, sentences.begin(), &LogPhrase::words);
        KnownSentence old = knownEnding(text, sentences);
        if (old.words != nullptr)
            news = {*std::ranges::find(All, old.words, &LogPhrase::words), std::move(old.values)};
    }
    const auto isFigure = [](const std::string& value) { return figureIn(value).has_value(); };
    return std::ranges::all_of(news.values, isFigure) ? news : ReadPhrase();
}

std::string message(const std::string& text) {
    const auto coded = codedText(text);
    const ReadPhrase news = newsIn(text);
    if (!coded || !news.phrase) return text;
    return coded->value("file").value_or(std::string()) + ": " + wordsOf("leitstand::LogSays", news);
}

}  // namespace leitstand::log_format
