#pragma once

#include <vector>

#include <QString>

#include "core/mission/mission_state.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// A victim, or another find, as it stands in a list.
struct FindRow {
    FindKey key;
    Time found{};     ///< station's clock
    QString name;     ///< "V1"
    QString status;   ///< "hypothesis", "confirmed", "discarded", "part of V2"
    QString since;    ///< "12:04:31"
    QString place;    ///< x y z in the map [m]
    QString details;  ///< tag, situation and text, as far as they are known
    Tone tone = Tone::Normal;

    friend bool operator==(const FindRow&, const FindRow&) = default;
};

/// The finds of @p state, victims first, by number; discarded ones too.
[[nodiscard]] std::vector<FindRow> findRowsOf(const MissionState& state);

[[nodiscard]] QString statusText(const VictimSample& find);
/// "surface", "trapped", "void", "entombed" in words; "unknown" of an empty one.
[[nodiscard]] QString situationText(const std::string& situation);
/// Likewise "yellow", "orange", "red".
[[nodiscard]] QString areaText(const std::string& area);

}  // namespace leitstand
