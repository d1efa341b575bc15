#include "core/version/version.h"

namespace leitstand {

std::string versionOf(const char* program) {
    const std::string built = commit();
    return std::string(program) + ' ' + version() + (built.empty() ? "" : " (" + built + ')');
}

}  // namespace leitstand
