#include "core/mapping/placement/placement_format.h"

#include <string_view>

namespace leitstand::placement_format {

bool isPhrase(const std::string& how, const LogPhrase& phrase) {
    const ReadPhrase read = readPhrase(how, All);
    return read.phrase && read.phrase->code == std::string_view(phrase.code);
}

std::string inWindowsLanguage(const std::string& how) {
    ReadPhrase read = readPhrase(how, All);
    if (!read.phrase) return how;
    for (std::string& value : read.values) value = inWindowsLanguage(value);
    return wordsOf("leitstand::Station", read);
}

}  // namespace leitstand::placement_format
