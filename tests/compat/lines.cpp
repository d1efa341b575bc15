#include "tests/compat/lines.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "tests/support/places.h"

namespace leitstand::test {

std::filesystem::path compatFile(const std::string& name) {
    return std::filesystem::path(sourceFolder()) / "tests/compat" / name;
}

std::vector<std::string> linesOf(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file.string() + ": cannot be opened");
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) {
        if (!line.empty() && line.front() != '#') lines.push_back(line);
    }
    return lines;
}

std::vector<std::string> goneFrom(const std::string& list, const std::vector<std::string>& found) {
    std::vector<std::string> gone;
    for (const std::string& line : linesOf(compatFile(list))) {
        if (std::find(found.begin(), found.end(), line) == found.end()) gone.push_back(line);
    }
    return gone;
}

}  // namespace leitstand::test
