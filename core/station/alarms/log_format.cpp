#include "core/station/alarms/log_format.h"

#include <algorithm>

namespace leitstand::log_format {

KnownSentence newsIn(std::string_view text) {
    KnownSentence news = knownEnding(text, All);
    const auto isFigure = [](const std::string& value) { return figureIn(value).has_value(); };
    return std::ranges::all_of(news.values, isFigure) ? news : KnownSentence();
}

}  // namespace leitstand::log_format
