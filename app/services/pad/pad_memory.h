#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Stores the bindings of the operator's gamepads from run to run: one file for each kind of pad, in a folder
/// of the configuration.
class PadMemory {
public:
    /// @p folder: made when something is stored; empty: nothing is stored.
    explicit PadMemory(std::filesystem::path folder);

    /// Returns what was stored for the pad with this @p guid, which names maker and model (letters and
    /// digits). Returns the defaults of @p layout if nothing was stored for this layout. Sets @p warning to
    /// why a file cannot be read; empty: there is no problem.
    [[nodiscard]] PadBindings bindings(const std::string& guid, PadLayout layout, std::string& warning) const;
    /// Stores @p bindings. @p name: what the pad calls itself. Errors name the file.
    Result<void> keep(const std::string& guid, const std::string& name, const PadBindings& bindings) const;

private:
    [[nodiscard]] std::filesystem::path fileOf(const std::string& guid) const;

    std::filesystem::path m_folder;
};

}  // namespace leitstand
