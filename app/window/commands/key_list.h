#pragma once

#include <vector>

#include <QString>

class QWidget;

namespace leitstand {

/// Keys or mouse buttons, and what they do.
struct KeyLine {
    QString keys, meaning;
    bool operator==(const KeyLine&) const = default;
};

/// Keys of one kind, under a title.
struct KeyColumn {
    QString title;
    std::vector<KeyLine> lines;
};

/// Returns keys and meanings of all commands with keys in the menus of @p window, each line once. Includes
/// keys that are only written behind a tab in a command's text, because another object handles them.
[[nodiscard]] std::vector<KeyLine> commandKeys(const QWidget& window);

/// Returns a read-only table with @p columns side by side. The caller owns it.
[[nodiscard]] QWidget* makeKeyTable(const std::vector<KeyColumn>& columns);

}  // namespace leitstand
