#pragma once

#include <string>
#include <vector>

#include <QString>

#include "core/robot/samples/victim_sample.h"

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
    QString name;         ///< "Heat"
    QString unit;         ///< of its value, "°C"; empty: it has none
    QString placeholder;  ///< what one may write: "waving, breathing …"
};
[[nodiscard]] std::vector<SignField> signFields();

/// "unknown", "absent", "present".
[[nodiscard]] QString signStateText(VictimSign::State state);

}  // namespace leitstand
