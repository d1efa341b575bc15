#pragma once

#include <filesystem>

namespace leitstand {

/// Returns the folder of the user's files of a @p kind ("robots"): `$XDG_CONFIG_HOME/leitstand/KIND`, else
/// `~/.config/leitstand/KIND`; empty when there is neither.
[[nodiscard]] std::filesystem::path userFolder(const char* kind);
/// Returns the folder of such files that come with the program: `$LEITSTAND_RESOURCES/KIND`, else
/// ../share/leitstand/KIND beside the binary.
[[nodiscard]] std::filesystem::path shippedFolder(const char* kind);

}  // namespace leitstand
