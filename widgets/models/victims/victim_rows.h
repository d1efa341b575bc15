#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/event/find_sample.h"
#include "core/mission/finds/find_moves.h"
#include "core/mission/state/mission_state.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// A victim, another find, or a candidate, as a row of a list and as a mark.
struct VictimRow {
    FindKey find{FindSample::Kind::Victim, 0};  ///< number 0: a candidate that is not filed
    std::uint32_t candidate = 0;                ///< CandidateSample::id; 0: it is a filed find
    QString name;                               ///< "V1"; of candidates "V?"
    QString what;                               ///< "victim", "hazard", "QR code", "object"
    QString state;                              ///< result of statusText(), or "candidate 82 %"
    QString where;                              ///< from the robot: "3.2 m, 40° left"
    QString signs;                              ///< "heat 33 °C · motion"
    bool confirmed = false;
    Tone tone = Tone::Normal;
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();  ///< [m]
    double deviation = Unknown;                       ///< [m]
    Time found{};        ///< when it was found, station's clock; for candidates, when it was last published
    QString since = {};  ///< "12:04:31"
    QString place = {};  ///< x y z in the map [m]
    QString moved = {};  ///< movedText() of its last move with its scan; empty: it did not move
    bool discarded = false;

    [[nodiscard]] bool filed() const { return candidate == 0; }
    friend bool operator==(const VictimRow&, const VictimRow&) = default;
};

/// Returns all finds that are not discarded, sorted by kind and number, then candidateRows(). @p robotInMap:
/// pose of the selected robot, for VictimRow::where; empty: unknown. @p moves: moves in this mission, for
/// VictimRow::moved; null: rows do not show moves.
[[nodiscard]] std::vector<VictimRow> victimRows(const MissionState& mission,
                                                const std::optional<Pose>& robotInMap,
                                                const FindMoves* moves = nullptr);
/// Returns the candidates that are neither filed nor dismissed, the most certain first. Those below
/// LeastShownConfidence are left out.
[[nodiscard]] std::vector<VictimRow> candidateRows(const MissionState& mission,
                                                   const std::optional<Pose>& robotInMap);
/// Returns everything that was ever filed, including what was discarded since, sorted by kind and number.
[[nodiscard]] std::vector<VictimRow> filedRows(const MissionState& mission, const FindMoves* moves = nullptr);

/// "confirmed", "unconfirmed", "discarded", "part of V2".
[[nodiscard]] QString statusText(const FindSample& find);
/// Returns the text for "surface", "trapped", "void" or "entombed". Any other word is not changed.
[[nodiscard]] QString situationText(const std::string& situation);

/// Returns where @p place is, as seen from a robot: "3.2 m, 40° left".
[[nodiscard]] QString whereText(const Pose& robotInMap, const Eigen::Vector3d& place);
/// Returns a short text of what is known about @p find, remarks last: "heat 33 °C · motion · trapped · R-17".
[[nodiscard]] QString signsText(const FindSample& find);
/// "victim", "hazard", "QR code", "object".
[[nodiscard]] QString kindText(FindSample::Kind kind);
/// "2 victims, 1 not confirmed · 3 candidates · 1 discarded": the title of the list.
[[nodiscard]] QString victimsTitle(const std::vector<VictimRow>& rows);

}  // namespace leitstand
