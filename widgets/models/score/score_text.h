#pragma once

#include <vector>

#include <QString>

#include "core/mission/score/score.h"
#include "core/mission/state/mission_clock.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// One line of the score's pane: an item and its points.
struct ScoreLine {
    QString what;
    QString points;
    Tone tone = Tone::Normal;
    QString items = {};  ///< of a confirmed victim, before any factor: "place 10/10, heat 0/2.5"
    friend bool operator==(const ScoreLine&, const ScoreLine&) = default;
};

/// The estimate in short.
struct ScoreText {
    QString score;                  ///< "74.3 points"
    QString rules;                  ///< "RoboCup Rescue 2005 · version 1.0 · 6 values unconfirmed"
    QString left;                   ///< "12 min left"; empty without a limit
    std::vector<ScoreLine> finds;   ///< points of each, penalties, operators
    std::vector<ScoreLine> advice;  ///< gains of one more step, largest first, at most five
    friend bool operator==(const ScoreText&, const ScoreText&) = default;
};

/// Returns the text of @p result by @p profile.
[[nodiscard]] ScoreText scoreText(const ScoreProfile& profile, const ScoreResult& result,
                                  const MissionClock& clock);

}  // namespace leitstand
