#include "tests/support/places.h"

#include <filesystem>

namespace leitstand::test {

const std::string& sourceFolder() {
    static const std::string folder = LEITSTAND_SOURCE_DIR;
    return folder;
}

std::string program(const std::string& name) {
    return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

}  // namespace leitstand::test
