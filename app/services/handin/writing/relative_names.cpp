#include "app/services/handin/writing/relative_names.h"

#include <string_view>
#include <system_error>

namespace leitstand {
namespace {

namespace fs = std::filesystem;

/// Removes @p prefix wherever a path in @p text begins with it.
void takeAway(std::string& text, const std::string& prefix) {
    constexpr std::string_view Before = " \t\n\"'(<[";
    if (prefix.empty()) return;
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at)) {
        if (at == 0 || Before.find(text[at - 1]) != std::string_view::npos) {
            text.erase(at, prefix.size());
        } else {
            at += prefix.size();
        }
    }
}

/// Replaces @p folder itself by its own name.
void callByName(std::string& text, const std::string& folder, const std::string& name) {
    if (folder.size() < 2 || folder == name) return;  // "." would match too much
    for (auto at = text.find(folder + ':'); at != std::string::npos; at = text.find(folder + ':', at + 1)) {
        if (at == 0 || text[at - 1] == ' ') text.replace(at, folder.size(), name);
    }
}

}  // namespace

std::string namedWithin(std::string text, const fs::path& mission) {
    std::error_code ignored;
    const fs::path folder = fs::is_directory(mission, ignored) ? mission : mission.parent_path();
    const fs::path whole = fs::absolute(folder, ignored);
    const fs::path normal = whole.lexically_normal();
    const std::string name = (normal.has_filename() ? normal : normal.parent_path()).filename().string();
    for (const fs::path& one : {folder, whole, normal}) {
        if (one.empty()) continue;
        const std::string prefix = (one / "").string();
        takeAway(text, prefix);
        callByName(text, prefix.substr(0, prefix.size() - 1), name);
    }
    return text;
}

}  // namespace leitstand
