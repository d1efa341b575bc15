#include <fstream>
#include <iterator>
#include <system_error>

#include "core/base/words.h"
#include "core/io/detail/output_file.h"
#include "core/io/robot/editing/robot_edits.h"
#include "core/io/settings/folders.h"

namespace leitstand {
namespace fs = std::filesystem;

namespace {

/// Returns the file to write for a robot that was read from @p file: the user's own, never the program's.
/// Empty: the user has no folder.
fs::path ownFile(const fs::path& file) {
    std::error_code problem;
    fs::path whole = fs::weakly_canonical(file, problem);
    const bool comes = fs::equivalent(shippedFolder("robots"), whole.parent_path(), problem);
    if (!comes) return whole;
    const fs::path folder = userFolder("robots");
    return folder.empty() ? folder : folder / whole.filename();
}

}  // namespace

Result<std::string> editRobotFile(const fs::path& file, const RobotEdit& edit) {
    const fs::path own = ownFile(file);
    std::error_code problem;
    std::ifstream in(!own.empty() && fs::exists(own, problem) ? own : file, std::ios::binary);
    if (!in)
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected a robot's file, found none that can be read"),
            file.string())};
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const auto changed = edit(text, own.empty() ? file.string() : own.string());
    if (!changed) return changed.error();
    if (own.empty())
        return Error{leitstand::fill(translate("leitstand::Error",
                                               "{}: it came with the program, and neither "
                                               "HOME nor XDG_CONFIG_HOME tells where a copy goes"),
                                     file.string())};
    fs::create_directories(own.parent_path(), problem);
    if (const auto whole = detail::writeWhole(own, *changed); !whole) return whole.error();
    return own.string();
}

}  // namespace leitstand
