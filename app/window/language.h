#pragma once

#include <functional>
#include <vector>

#include <QString>

namespace leitstand {

class CommandTable;

/// A language that the window speaks.
struct Language {
    QString code;  ///< ISO 639-1, "de"
    QString name;  ///< in that language
};
/// English first.
[[nodiscard]] const std::vector<Language>& languages();

/// Texts, numbers and dates are in the language @p code from now on; windows that are there keep theirs until
/// they are made anew. English when there is no such language; false then.
bool useLanguage(const QString& code);
/// Code of the language in use.
[[nodiscard]] QString presentLanguage();
/// The language of this computer's user, as far as the window speaks it, else English.
[[nodiscard]] QString systemLanguage();

/// Adds the languages to the menu View of @p commands; @p choose is told the code of the chosen one.
void addLanguageCommands(CommandTable& commands, const std::function<void(const QString& code)>& choose);

}  // namespace leitstand
