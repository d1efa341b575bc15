#include "core/mapping/placement/placement_says.h"

#include "core/base/said.h"

namespace leitstand::placement_says {

std::string inWindowsLanguage(const std::string& how) {
    SaidSentence said = knownSentence(how, All);
    if (said.words == nullptr) return how;
    for (std::string& value : said.values) value = inWindowsLanguage(value);
    return withValues(translate("leitstand::Station", said.words), said.values);
}

}  // namespace leitstand::placement_says
