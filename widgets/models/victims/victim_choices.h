#pragma once

#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/event/find_sample.h"

namespace leitstand {

/// A word in the log, and the text for it that the operator reads.
struct VictimChoice {
    std::string word;  ///< empty: nothing is known
    QString text;
};

/// Returns the choices of a victim's form; the first of each is "unknown".
[[nodiscard]] std::vector<VictimChoice> situationChoices();
[[nodiscard]] std::vector<VictimChoice> areaChoices();

/// One sign of life on the form.
struct SignField {
    VictimSign FindSample::*sign;
    QString name;       ///< "Heat"
    QString unit;       ///< unit of the value, "°C"; empty: the sign has no value
    QStringList words;  ///< common words for the sign: "waving", "breathing"
    /// Range of usual values, for setting a value without a keyboard.
    struct Range {
        double usual = 0.0, step = 1.0, least = 0.0, most = 0.0;  ///< in SignField::unit
    } range = {};
};
[[nodiscard]] std::vector<SignField> signFields();

/// Returns a hint about what to write: "waving, breathing"; with @p more "waving, breathing …".
[[nodiscard]] QString hintText(const QStringList& words, bool more);

/// Returns common remarks about a find.
[[nodiscard]] QStringList remarkChoices();

/// "unknown", "absent", "present".
[[nodiscard]] QString signStateText(VictimSign::State state);

}  // namespace leitstand
