#pragma once

#include <functional>

class QMenu;
class QString;

namespace leitstand {

class CommandTable;

/// Adds the languages to the View menu of @p commands. Calls @p choose with the code of the language that the
/// operator selects: "de".
void addLanguageCommands(CommandTable& commands, const std::function<void(const QString& code)>& choose);
/// Adds the languages to @p menu, for a window without a CommandTable.
void addLanguages(QMenu& menu, const std::function<void(const QString& code)>& choose);

}  // namespace leitstand
