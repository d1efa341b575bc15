#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/settings/window_layout.h"

namespace leitstand {

/// The layouts that come with the program, and the user's own, which have priority.
class LayoutBook {
public:
    /// Uses the folders of the user (`$XDG_CONFIG_HOME/leitstand/layouts`) and of the program
    /// (`$LEITSTAND_RESOURCES/layouts`).
    LayoutBook();
    /// @p own: folder to which save() writes.
    LayoutBook(std::filesystem::path own, std::filesystem::path shipped);

    /// Returns the shipped layouts in their order, then the user's. Adds errors of invalid files to
    /// @p errors.
    [[nodiscard]] std::vector<WindowLayout> all(std::vector<std::string>& errors) const;
    /// Returns the layout @p name. The error lists the existing names, or says what is wrong with the file.
    [[nodiscard]] Result<WindowLayout> find(const std::string& name) const;
    /// The error names the file, or the invalid name.
    Result<void> save(const WindowLayout& layout) const;
    /// Removes one of the user's layouts. If there is a shipped one with that name, it is used again.
    Result<void> remove(const std::string& name) const;
    [[nodiscard]] bool isOwn(const std::string& name) const;

private:
    std::filesystem::path m_own, m_shipped;
};

}  // namespace leitstand
