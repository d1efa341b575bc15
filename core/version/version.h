#pragma once

#include <string>

namespace leitstand {

/// "0.2.0".
[[nodiscard]] const char* version();
/// The commit from which the program was built: twelve digits, with "+changes" if files differed from it.
/// Empty if it was not built from a checkout.
[[nodiscard]] const char* commit();
/// What `PROGRAM --version` prints: "leitstandctl 0.2.0 (0123456789ab)".
[[nodiscard]] std::string versionOf(const char* program);

}  // namespace leitstand
