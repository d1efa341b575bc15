#include "tests/support/shared_data.h"

#include <cstdlib>

#include "tests/support/places.h"

namespace leitstand::test {

std::optional<std::filesystem::path> sharedData() {
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (const char* set = std::getenv("LEITSTAND_SHARED_DATA"); set != nullptr && *set != '\0') {
        return fs::is_directory(fs::path(set) / "kurt3d-hall", ignored) ? std::optional<fs::path>(set)
                                                                        : std::nullopt;
    }
    const fs::path beside = fs::path(sourceFolder()).parent_path() / "shared" / "data";
    if (fs::is_directory(beside / "kurt3d-hall", ignored)) return beside;
    return std::nullopt;
}

}  // namespace leitstand::test
