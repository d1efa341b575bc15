#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <QSize>

#include "app/window/shell/window_state.h"
#include "core/settings/domain_settings.h"

namespace leitstand {

/// What the command line asks for.
struct Options {
    Sources scans;
    std::string screenshot;  ///< file to write; empty: no screenshot
    std::optional<MapLook> look;
    std::optional<Theme> theme;
    std::string language;  ///< code, "de"; empty: as stored, otherwise the user's; English in screenshots
    bool registerAgain = false;  ///< register a mission's scans again instead of reviewing it
    std::optional<QSize> size;   ///< size of the screenshot [px]; empty: a window of 1280 x 800
    int after = 0;               ///< for a screenshot of live robots: delay after everything is shown [s]
    // The station on live robots:
    bool live = false;                ///< whether to open a window for live robots instead of scans
    bool demo = false;                ///< whether to start simulated robots; then `live` is set, too
    std::vector<std::string> robots;  ///< files or names of robots; empty: Kurt3D and the Crawler
    std::string mission;              ///< folder; empty: a new one
    bool resume = false;              ///< whether to continue the newest mission on this computer
    std::string mapOf;                ///< folder of a mission in whose map the new mission begins
    std::string layout;               ///< name of the layout; empty: the one used last
    DomainOptions network = {};       ///< how to join the robots' domain
};

/// Reads the command line. Returns its options. If help, version or an error was printed, returns the exit
/// status: 0, or 2 for wrong usage.
[[nodiscard]] std::variant<Options, int> parseOptions(int argc, const char* const* argv);

}  // namespace leitstand
