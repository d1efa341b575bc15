#pragma once

#include <filesystem>

namespace leitstand::test {

/// Writes the configuration of an operator who changed everything that can be changed, by the program's own
/// windows, into @p home (which is the user's: HOME, and XDG_CONFIG_HOME in it), and how the panes were then
/// into @p home / "panes". @p mission: opened and reviewed meanwhile; it gets sessions more.
void makeHome(const std::filesystem::path& home, const std::filesystem::path& mission);

/// Writes a mission of two sessions that has an event of every kind into @p folder.
void makeMission(const std::filesystem::path& folder);

}  // namespace leitstand::test
