#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/settings/window_layout.h"

namespace leitstand {

/// Layouts that come with the program, and the user's own, which go before them.
class LayoutBook {
public:
    /// Of the user (`$XDG_CONFIG_HOME/leitstand/layouts`) and of the program
    /// (`$LEITSTAND_RESOURCES/layouts`).
    LayoutBook();
    /// @p own: where save() writes.
    LayoutBook(std::filesystem::path own, std::filesystem::path shipped);

    /// The shipped ones in their order, then the user's; errors of files that make no sense go to @p errors.
    [[nodiscard]] std::vector<WindowLayout> all(std::vector<std::string>& errors) const;
    /// The error lists the names that there are, or tells what is wrong with the file.
    [[nodiscard]] Result<WindowLayout> find(const std::string& name) const;
    /// Errors name the file, or a name that is none.
    Result<void> save(const WindowLayout& layout) const;
    /// Takes one of the user's away; a shipped one of that name is there again.
    Result<void> remove(const std::string& name) const;
    [[nodiscard]] bool isOwn(const std::string& name) const;

private:
    std::filesystem::path m_own, m_shipped;
};

}  // namespace leitstand
