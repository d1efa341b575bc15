#include "core/mapping/placement/placement_format.h"

#include "core/base/known_sentence.h"

namespace leitstand::placement_format {

std::string inWindowsLanguage(const std::string& how) {
    KnownSentence reported = knownSentence(how, All);
    if (reported.words == nullptr) return how;
    for (std::string& value : reported.values) value = inWindowsLanguage(value);
    return withValues(translate("leitstand::Station", reported.words), reported.values);
}

}  // namespace leitstand::placement_format
