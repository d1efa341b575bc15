#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <QSize>

#include "app/window/shell/window_state.h"
#include "core/settings/domain_settings.h"

namespace leitstand {

/// What the command line requests.
struct Options {
    Sources scans;
    std::string screenshot;  ///< file to write; empty: none is wanted
    std::optional<MapLook> look;
    std::optional<Theme> theme;
    std::string language;  ///< code, "de"; empty: as remembered, else the user's; in screenshots English
    bool registerAgain = false;  ///< register a mission's scans again instead of reviewing it
    std::optional<QSize> size;   ///< of the screenshot [px]; none: a window of 1280 x 800
    int after = 0;               ///< screenshot: delay after all is shown; live robots only [s]
    // The station on live robots:
    bool live = false;                ///< instead of a window for scans
    bool demo = false;                ///< with simulated robots of its own; live is set, too
    std::vector<std::string> robots;  ///< files or names; empty: Kurt3D and the Crawler
    std::string mission;              ///< folder; empty: a new one
    bool resume = false;              ///< continue the newest mission of this computer
    std::string mapOf;                ///< folder of a mission; the new one begins in its map
    std::string layout;               ///< name; empty: the one used last
    DomainOptions network = {};       ///< of the robots' domain
};

/// Reads the command line. Returns its options, or the exit status after printing help, version or an error:
/// 0, or 2 for wrong usage.
[[nodiscard]] std::variant<Options, int> parseOptions(int argc, const char* const* argv);

}  // namespace leitstand
