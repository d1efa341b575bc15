#pragma once

#include <string_view>

namespace leitstand {

struct CandidateSample;
struct Decision;
struct MissionState;

/// Title of a review's session in the log, and beginning of the names of stations that write reviews. They
/// distinguish such a session from those of the mission.
inline constexpr std::string_view ReviewTitle = "Review", ReviewStation = "review";

/// An entry that was written in a review; both null: none.
struct ReviewWriting {
    const Decision* decision = nullptr;  ///< a note, or an entry on a find
    const CandidateSample* dismissal = nullptr;
    explicit operator bool() const { return decision != nullptr || dismissal != nullptr; }
};
/// Returns the newest entry of any review of @p mission that is not taken back, a decision or a dismissal.
/// Never returns what the mission recorded itself. Stays valid as long as @p mission.
[[nodiscard]] ReviewWriting newestWriting(const MissionState& mission);

}  // namespace leitstand
