#include "core/io/settings/folders.h"

#include <cstdlib>
#include <string>
#include <system_error>

namespace leitstand {
namespace fs = std::filesystem;
namespace {

/// Returns the value of environment variable @p variable; empty when it is not set.
std::string environment(const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr ? std::string() : value;
}

}  // namespace

fs::path userFolder(const char* kind) {
    if (const fs::path config = environment("XDG_CONFIG_HOME"); !config.empty())
        return config / "leitstand" / kind;
    const fs::path home = environment("HOME");
    return home.empty() ? fs::path() : home / ".config/leitstand" / kind;
}

fs::path shippedFolder(const char* kind) {
    if (const fs::path resources = environment("LEITSTAND_RESOURCES"); !resources.empty())
        return resources / kind;
    std::error_code problem;
    const fs::path program = fs::read_symlink("/proc/self/exe", problem);
    return problem ? fs::path() : program.parent_path().parent_path() / "share/leitstand" / kind;
}

}  // namespace leitstand
