#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <QSize>

#include "app/window/shell/window_state.h"

namespace leitstand {

/// What the command line asks for.
struct Options {
    Sources scans;
    std::string screenshot;  ///< file to write; empty: none is wanted
    std::optional<MapLook> look;
    std::optional<Theme> theme;
    std::string language;        ///< "de"; empty: as remembered, else the user's
    bool registerAgain = false;  ///< a mission is registered anew, not reviewed
    std::optional<QSize> size;   ///< of the screenshot [px]; none: a window of 1280 x 800
    int after = 0;               ///< all is shown the screenshot is taken; on live robots [s]
    // The station on live robots:
    bool live = false;                    ///< in place of a window for scans
    bool demo = false;                    ///< with simulated robots of its own
    std::vector<std::string> robots;      ///< files or names; empty: Kurt3D and the Crawler
    std::string mission;                  ///< folder; empty: a new one
    bool resume = false;                  ///< the newest of this computer is gone on with
    std::string mapOf;                    ///< folder of the mission whose map the new one begins in
    std::string layout;                   ///< name; empty: the one used last
    std::string keys;                     ///< folder of an identity; empty: no security
    int domain = 0;                       ///< DDS domain
    std::vector<std::string> interfaces;  ///< network cards; empty: all
};

/// The options of @p argc, @p argv, or, after printing help, version or what is wrong with them, the exit
/// status: 0, or 2 for wrong usage.
[[nodiscard]] std::variant<Options, int> parseOptions(int argc, const char* const* argv);

}  // namespace leitstand
