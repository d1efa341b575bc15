#pragma once

#include <string_view>

#include "core/mission/state/mission_state.h"

namespace leitstand {

/// What tells a review's session in the log from those of the mission: its title, and what names of stations
/// that write reviews begin with.
inline constexpr std::string_view ReviewTitle = "Review", ReviewStation = "review";

/// Something that was written in a review; both null: nothing.
struct ReviewWriting {
    const Decision* decision = nullptr;  ///< a note, or an entry on a find
    const CandidateSample* dismissal = nullptr;
    explicit operator bool() const { return decision != nullptr || dismissal != nullptr; }
};
/// The newest that was written in any review of @p mission and is not taken back, one of both; never what the
/// mission recorded itself. Stays valid as long as @p mission.
[[nodiscard]] ReviewWriting newestWriting(const MissionState& mission);

}  // namespace leitstand
