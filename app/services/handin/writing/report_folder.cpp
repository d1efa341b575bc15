#include "app/services/handin/writing/report_folder.h"

#include <fstream>
#include <string>
#include <system_error>

#include "core/io/detail/output_file.h"

namespace leitstand {
namespace {

constexpr std::size_t LongestPath = 4096;  ///< [bytes]

std::filesystem::path fileOf(const std::filesystem::path& mission) {
    return mission / "report_folder.txt";
}

}  // namespace

std::filesystem::path reportFolderOf(const std::filesystem::path& mission) {
    std::ifstream in(fileOf(mission), std::ios::binary);
    std::string text(LongestPath + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (text.ends_with('\n')) text.pop_back();
    // Anything but an absolute path is none of ours.
    const bool sound = text.size() < LongestPath && text.find('\0') == std::string::npos;
    const std::filesystem::path out = sound ? text : std::string();
    return out.is_absolute() ? out : std::filesystem::path();
}

Result<void> keepReportFolder(const std::filesystem::path& mission, const std::filesystem::path& out) {
    std::error_code problem;
    if (!out.empty())
        return detail::writeWhole(fileOf(mission), std::filesystem::absolute(out).string() + '\n');
    std::filesystem::remove(fileOf(mission), problem);
    if (problem) return Error{fileOf(mission).string() + ": " + problem.message()};
    return {};
}

}  // namespace leitstand
