#include "tests/architecture/sources.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/places.h"

namespace leitstand::test {

namespace fs = std::filesystem;

std::vector<std::string> sources(std::initializer_list<const char*> folders) {
    std::vector<std::string> found;
    for (const char* top : folders) {
        const fs::path folder = fs::path(sourceFolder()) / top;
        EXPECT_TRUE(fs::is_directory(folder)) << folder << ": the rules name a folder that is not there";
        if (!fs::is_directory(folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            const auto ending = entry.path().extension();
            if (ending == ".h" || ending == ".cpp") {
                found.push_back(fs::relative(entry.path(), sourceFolder()).generic_string());
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string content(const std::string& source) {
    std::ifstream in(fs::path(sourceFolder()) / source);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace leitstand::test
