#pragma once

#include <vector>

#include <QString>

namespace leitstand {

/// A language of the window and the report.
struct Language {
    QString code;  ///< ISO 639-1, "de"
    QString name;  ///< name in that language
};
/// Returns the languages, English first.
[[nodiscard]] const std::vector<Language>& languages();

/// Sets the language of texts, numbers and dates; requires a QCoreApplication. Existing windows keep their
/// language until they are created again. Sets English and returns false when there is no language with this
/// @p code.
bool useLanguage(const QString& code);
/// Returns the code of the language in use.
[[nodiscard]] QString presentLanguage();
/// Returns the code of the user's system language if it is one of languages(), otherwise that of English.
[[nodiscard]] QString systemLanguage();

}  // namespace leitstand
