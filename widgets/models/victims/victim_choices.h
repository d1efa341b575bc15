#pragma once

#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/event/victim_sample.h"

namespace leitstand {

/// A word of the log and what the operator reads for it.
struct VictimChoice {
    std::string word;  ///< empty: nothing is known
    QString text;
};

/// What a victim's form can be filled in with; the first of each is "unknown".
[[nodiscard]] std::vector<VictimChoice> situationChoices();
[[nodiscard]] std::vector<VictimChoice> areaChoices();

/// One sign of life on the form.
struct SignField {
    VictimSign VictimSample::*sign;
    QString name;       ///< "Heat"
    QString unit;       ///< of its value, "°C"; empty: it has none
    QStringList words;  ///< what is often said of it: "waving", "breathing"
    /// What its value is by and large, so that it can be found without a keyboard.
    struct Range {
        double usual = 0.0, step = 1.0, least = 0.0, most = 0.0;  ///< in its unit
    } range = {};
};
[[nodiscard]] std::vector<SignField> signFields();

/// What one may write, as a hint: "waving, breathing"; with @p more "waving, breathing …".
[[nodiscard]] QString hintText(const QStringList& words, bool more);

/// What remarks on a find often say.
[[nodiscard]] QStringList remarkChoices();

/// "unknown", "absent", "present".
[[nodiscard]] QString signStateText(VictimSign::State state);

}  // namespace leitstand
