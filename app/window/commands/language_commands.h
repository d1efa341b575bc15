#pragma once

#include <functional>

class QString;

namespace leitstand {

class CommandTable;

/// Adds the languages to the menu View of @p commands; @p choose is told the code of the chosen one.
void addLanguageCommands(CommandTable& commands, const std::function<void(const QString& code)>& choose);

}  // namespace leitstand
