#include "core/io/model/package_files.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace leitstand {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> listIn(const char* variable) {
    std::vector<std::string> parts;
    const char* const value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nobody sets it
    std::string_view rest = value == nullptr ? "" : value;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        if (end > 0) parts.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return parts;
}

bool isWithin(const fs::path& file, const fs::path& folder) {
    const fs::path relative = file.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

/// Returns @p path without links, if it is a file within @p folder; otherwise an empty path.
fs::path fileWithin(const fs::path& folder, const fs::path& path) {
    std::error_code problem;
    const fs::path file = fs::canonical(path, problem);
    if (problem || !fs::is_regular_file(file, problem) || problem) return {};
    // Packages of workspaces are often links, as colcon's --symlink-install makes them. Links are followed
    // where the path itself leads nowhere else.
    return isWithin(path.lexically_normal(), folder.lexically_normal()) ? file : fs::path();
}

}  // namespace

PackageFiles PackageFiles::of(const RobotDescription& robot) {
    std::vector<fs::path> folders;
    for (const std::string& folder : robot.packages)
        folders.push_back(fs::path(robot.file).parent_path() / folder);
    for (const std::string& prefix : listIn("AMENT_PREFIX_PATH"))
        folders.push_back(fs::path(prefix) / "share");
    for (const std::string& folder : listIn("ROS_PACKAGE_PATH")) folders.emplace_back(folder);
    return PackageFiles(std::move(folders));
}

Result<fs::path> PackageFiles::find(const std::string& uri) const {
    constexpr std::string_view File = "file://";
    std::string_view rest = uri;
    std::string_view package;
    for (const std::string_view scheme : {"package://", "model://"}) {
        if (!rest.starts_with(scheme)) continue;
        rest.remove_prefix(scheme.size());
        package = rest.substr(0, rest.find('/'));
        if (package.empty() || package.size() == rest.size())
            return Error{fmt::format("{}: expected package://NAME/PATH", uri)};
    }
    if (rest.starts_with(File)) rest.remove_prefix(File.size());
    if (package.empty() && rest.find("://") != std::string_view::npos)
        return Error{fmt::format("{}: expected package://, model:// or file://", uri)};
    for (const fs::path& folder : m_folders) {
        std::vector<fs::path> candidates;
        if (package.empty()) {
            candidates.emplace_back(folder / fs::path(rest));
        } else {
            candidates.emplace_back(folder / fs::path(rest));
            if (folder.filename() == fs::path(package))
                candidates.emplace_back(folder.parent_path() / fs::path(rest));
        }
        for (const fs::path& candidate : candidates) {
            const fs::path file = fileWithin(folder, candidate);
            if (!file.empty()) return file;
        }
    }
    return Error{package.empty() ? fmt::format("{}: not in the folders of the robot's file (packages)", uri)
                                 : fmt::format("{}: no folder of the robot's file (packages) has package {}",
                                               uri, package)};
}

}  // namespace leitstand
