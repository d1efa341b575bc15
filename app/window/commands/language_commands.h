#pragma once

#include <functional>

class QMenu;
class QString;

namespace leitstand {

class CommandTable;

/// Adds the languages to the menu View of @p commands; @p choose is told the code of the chosen one.
void addLanguageCommands(CommandTable& commands, const std::function<void(const QString& code)>& choose);
/// The same for a window without such a table: into @p menu.
void addLanguages(QMenu& menu, const std::function<void(const QString& code)>& choose);

}  // namespace leitstand
