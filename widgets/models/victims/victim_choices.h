#pragma once

#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/event/find_sample.h"

namespace leitstand {

/// A word of the log and the text that the operator reads for it.
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
    QString unit;       ///< of its value, "°C"; empty: it has none
    QStringList words;  ///< frequent words for it: "waving", "breathing"
    /// Usual values, so that one can be set without a keyboard.
    struct Range {
        double usual = 0.0, step = 1.0, least = 0.0, most = 0.0;  ///< in its unit
    } range = {};
};
[[nodiscard]] std::vector<SignField> signFields();

/// Returns a hint of what to write: "waving, breathing"; with @p more "waving, breathing …".
[[nodiscard]] QString hintText(const QStringList& words, bool more);

/// Returns frequent remarks on a find.
[[nodiscard]] QStringList remarkChoices();

/// "unknown", "absent", "present".
[[nodiscard]] QString signStateText(VictimSign::State state);

}  // namespace leitstand
