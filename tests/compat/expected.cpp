#include "tests/compat/expected.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "tests/compat/lines.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

std::vector<std::string> split(const std::string& text, const char* at) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(at, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

bool isSame(const std::string& expected, const std::string& found, double tolerance) {
    if (expected == found) return true;
    if (tolerance <= 0.0) return false;
    const auto wanted = split(expected, " ,"), words = split(found, " ,");
    if (wanted.size() != words.size()) return false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (wanted[i] == words[i]) continue;
        char *end = nullptr, *other = nullptr;
        const double want = std::strtod(wanted[i].c_str(), &end),
                     have = std::strtod(words[i].c_str(), &other);
        if (*end != '\0' || *other != '\0' || !(std::abs(want - have) <= tolerance)) return false;
    }
    return true;
}

}  // namespace

testing::AssertionResult isAsExpected(const std::string& expected, const std::string& found,
                                      double tolerance) {
    constexpr int MostTold = 12;
    if (const char* folder = std::getenv("LEITSTAND_COMPAT_FOUND")) {
        const std::filesystem::path file = std::filesystem::path(folder) / expected;
        std::filesystem::create_directories(file.parent_path());
        writeText(file, found);
    }
    const std::filesystem::path file = compatFile(expected);
    if (!std::filesystem::exists(file)) return testing::AssertionFailure() << file << " is not there";
    const auto wanted = split(readText(file), "\n"), lines = split(found, "\n");
    std::ostringstream out;
    int differences = 0;
    for (std::size_t i = 0; i < std::max(wanted.size(), lines.size()); ++i) {
        const std::string want = i < wanted.size() ? wanted[i] : "(no line)",
                          have = i < lines.size() ? lines[i] : "(no line)";
        if (isSame(want, have, tolerance)) continue;
        if (++differences <= MostTold)
            out << "\n" << expected << ":" << i + 1 << ": " << want << "\n  found: " << have;
    }
    if (differences == 0) return testing::AssertionSuccess();
    return testing::AssertionFailure() << differences << " lines differ" << out.str();
}

}  // namespace leitstand::test
