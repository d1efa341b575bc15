#pragma once

#include <vector>

#include <QString>

namespace leitstand {

/// A language that window and report speak.
struct Language {
    QString code;  ///< ISO 639-1, "de"
    QString name;  ///< in that language
};
/// English first.
[[nodiscard]] const std::vector<Language>& languages();

/// Texts, numbers and dates are in the language @p code from now on, where a QCoreApplication lives; windows
/// that are there keep theirs until they are made anew. English when there is no such language; false then.
bool useLanguage(const QString& code);
/// Code of the language in use.
[[nodiscard]] QString presentLanguage();
/// The language of this computer's user, as far as it is spoken here, else English.
[[nodiscard]] QString systemLanguage();

}  // namespace leitstand
