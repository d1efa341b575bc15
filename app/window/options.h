#pragma once

#include <optional>
#include <string>
#include <variant>

#include <QSize>

#include "app/window/window_state.h"

namespace leitstand {

/// What the command line asks for.
struct Options {
    Sources scans;
    std::string screenshot;  ///< file to write; empty: none is wanted
    std::optional<MapLook> look;
    std::optional<Theme> theme;
    QSize size{1280, 800};  ///< of the window on a screenshot [px]
};

/// The options of @p argc, @p argv, or, after printing help, version or what is wrong with them, the exit
/// status: 0, or 2 for wrong usage.
[[nodiscard]] std::variant<Options, int> parseOptions(int argc, const char* const* argv);

}  // namespace leitstand
