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
    QString items = {};  ///< for a confirmed victim, before any factor: "place 10/10, heat 0/2.5"
    friend bool operator==(const ScoreLine&, const ScoreLine&) = default;
};

/// The estimated score as short texts.
struct ScoreText {
    QString score;                  ///< "74.3 points"
    QString rules;                  ///< "RoboCup Rescue 2005 · version 1.0 · 6 values unconfirmed"
    QString left;                   ///< "12 min left"; empty: the mission has no length
    std::vector<ScoreLine> finds;   ///< points of each find, penalties, operators
    std::vector<ScoreLine> advice;  ///< gains of possible next steps, largest first, at most five
    friend bool operator==(const ScoreText&, const ScoreText&) = default;
};

/// Returns the text of @p result under the rules @p profile.
[[nodiscard]] ScoreText scoreText(const ScoreProfile& profile, const ScoreResult& result,
                                  const MissionClock& clock);

}  // namespace leitstand
