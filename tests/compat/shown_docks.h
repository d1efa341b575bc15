#pragma once

#include <string>
#include <vector>

class QMainWindow;

namespace leitstand::test {

/// How the docks of @p window are, a line for each, by name:
///
///     NAME AREA STATE X Y WIDTH HEIGHT [with NAME,NAME]
///
/// AREA is left, right, top or bottom; STATE is hidden, floating, front (seen) or behind (another tab is
/// seen). Places are thousandths of the window, of floating docks pixels of the screen, of docks not seen 0.
/// After "with" stand the docks that share its room as tabs.
[[nodiscard]] std::vector<std::string> shownDocks(const QMainWindow& window);

/// What of @p expected is not so in @p found, a line for each dock, which begins with its name. Docks that
/// are only in @p found are new panes, and no difference. @p renamed: a line "OLD NEW" for each dock that has
/// another name since.
[[nodiscard]] std::vector<std::string> dockDifferences(const std::vector<std::string>& expected,
                                                       const std::vector<std::string>& found,
                                                       const std::vector<std::string>& renamed);

}  // namespace leitstand::test
