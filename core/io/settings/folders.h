#pragma once

#include <filesystem>

namespace leitstand {

/// Returns the folder of the user's files of a @p kind ("robots"): `$XDG_CONFIG_HOME/leitstand/KIND`, or
/// ~/.config/leitstand/KIND. Empty when neither XDG_CONFIG_HOME nor HOME is set.
[[nodiscard]] std::filesystem::path userFolder(const char* kind);
/// Returns the folder of the files of a @p kind that come with the program. It is
/// `$LEITSTAND_RESOURCES/KIND`, or ../share/leitstand/KIND beside the binary.
[[nodiscard]] std::filesystem::path shippedFolder(const char* kind);

}  // namespace leitstand
