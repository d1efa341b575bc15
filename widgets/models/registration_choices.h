#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/mapping/registration_settings.h"

namespace leitstand {

/// One of several methods from which the operator can choose.
template <class T>
struct Choice {
    T value;
    const char* key;  ///< key on leitstandctl's command line and in the stored state
    QString name;     ///< name for the operator
    QString hint;     ///< what it does and who published it
};

// The choices of the registration's settings, in the order in which they are offered.
[[nodiscard]] std::vector<Choice<SearchMethod>> searchChoices();
[[nodiscard]] std::vector<Choice<Minimizer>> minimizerChoices();
[[nodiscard]] std::vector<Choice<ScanFilter>> filterChoices();
[[nodiscard]] std::vector<Choice<GuessSource>> guessChoices();  ///< without Poses, which would need a file
[[nodiscard]] std::vector<Choice<Reference>> referenceChoices();

/// Returns the value with the key @p key; empty for unknown keys.
template <class T>
[[nodiscard]] std::optional<T> valueOf(const std::vector<Choice<T>>& choices, const QString& key) {
    for (const Choice<T>& choice : choices) {
        if (key == QLatin1String(choice.key)) return choice.value;
    }
    return std::nullopt;
}
/// The key of @p value; empty when it is not among the choices.
template <class T>
[[nodiscard]] QString keyOf(const std::vector<Choice<T>>& choices, T value) {
    for (const Choice<T>& choice : choices) {
        if (choice.value == value) return QLatin1String(choice.key);
    }
    return {};
}

/// Parses maximum distances as an operator writes them, "1.5, 0.5" [m]. Empty unless all are between 0.01 and
/// 10 m and none is larger than the one before it.
[[nodiscard]] std::optional<std::vector<double>> parseSchedule(const QString& text);
/// Returns the text that parseSchedule() reads.
[[nodiscard]] QString scheduleText(const std::vector<double>& maxDistances);

/// Whether both give the same registration.
[[nodiscard]] bool sameSettings(const RegistrationSettings& a, const RegistrationSettings& b);

}  // namespace leitstand
