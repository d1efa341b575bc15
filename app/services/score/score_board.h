#pragma once

#include <string>
#include <vector>

#include "core/event/station_samples.h"
#include "core/io/settings/score_file.h"
#include "core/mission/score/score.h"

namespace leitstand {

/// The rules for scores that are known on this computer, and those of a mission.
class ScoreBoard {
public:
    ScoreBoard() : m_profiles(scoreProfiles()) {}
    explicit ScoreBoard(ScoreProfiles profiles) : m_profiles(std::move(profiles)) {}

    [[nodiscard]] const std::vector<ScoreProfile>& profiles() const { return m_profiles.profiles; }
    /// Texts about rules that could not be read.
    [[nodiscard]] const std::vector<std::string>& problems() const { return m_profiles.problems; }
    /// Returns the rules that @p mission names; if it names none, the newest. Null when there are none.
    [[nodiscard]] const ScoreProfile* profileOf(const MissionState& mission) const {
        return m_profiles.find(mission.info ? mission.info->sample.profile : std::string());
    }

private:
    ScoreProfiles m_profiles;
};

}  // namespace leitstand
