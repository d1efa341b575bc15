#pragma once

#include <vector>

#include <QString>

class QWidget;

namespace leitstand {

/// Keys, or buttons of the mouse, and what they do.
struct KeyLine {
    QString keys, meaning;
    bool operator==(const KeyLine&) const = default;
};

/// Keys of one kind, below a title.
struct KeyColumn {
    QString title;
    std::vector<KeyLine> lines;
};

/// Keys and meanings of all commands in the menus of @p window that have keys, without repetition. What
/// follows a tabulator in a command's text is a key that something else listens to.
[[nodiscard]] std::vector<KeyLine> commandKeys(const QWidget& window);

/// @p columns side by side, for reading.
[[nodiscard]] QWidget* makeKeyTable(const std::vector<KeyColumn>& columns);

}  // namespace leitstand
