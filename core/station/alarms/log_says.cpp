#include "core/station/alarms/log_says.h"

#include <algorithm>

namespace leitstand::log_says {

SaidSentence newsIn(std::string_view text) {
    SaidSentence news = knownEnding(text, All);
    const auto isFigure = [](const std::string& value) { return figureIn(value).has_value(); };
    return std::ranges::all_of(news.values, isFigure) ? news : SaidSentence();
}

}  // namespace leitstand::log_says
