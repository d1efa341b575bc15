#include "core/io/detail/unfinished.h"

#include <system_error>

namespace leitstand::detail {

namespace fs = std::filesystem;

Unfinished::Unfinished(const fs::path& folder) {
    std::error_code problem;
    fs::path whole = fs::absolute(folder, problem).lexically_normal();
    if (!whole.has_filename()) whole = whole.parent_path();
    // The highest missing folder: everything below it is ours.
    fs::path highest;
    while (!whole.empty() && whole != whole.root_path() && !fs::exists(fs::symlink_status(whole, problem))) {
        highest = whole;
        whole = whole.parent_path();
    }
    if (!highest.empty()) m_made.push_back(highest);
}

void Unfinished::file(const fs::path& file) {
    std::error_code problem;
    if (!fs::exists(fs::symlink_status(file, problem))) m_made.push_back(file);
}

Unfinished::~Unfinished() {
    std::error_code ignored;
    for (const fs::path& made : m_made) fs::remove_all(made, ignored);
}

}  // namespace leitstand::detail
