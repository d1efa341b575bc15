#pragma once

#include <filesystem>

namespace leitstand {

/// Where the user's files of a kind ("robots") are: `$XDG_CONFIG_HOME/leitstand/KIND`, else
/// `~/.config/leitstand/KIND`; empty when there is neither.
[[nodiscard]] std::filesystem::path userFolder(const char* kind);
/// Where those are that come with the program: `$LEITSTAND_RESOURCES/KIND`, else ../share/leitstand/KIND
/// beside the binary.
[[nodiscard]] std::filesystem::path shippedFolder(const char* kind);

}  // namespace leitstand
