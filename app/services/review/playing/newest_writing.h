#pragma once

#include <string_view>

namespace leitstand {

struct CandidateSample;
struct Decision;
struct MissionState;

/// Distinguish a review's session in the log from those of the mission: its title, and the beginning of the
/// names of stations that write reviews.
inline constexpr std::string_view ReviewTitle = "Review", ReviewStation = "review";

/// An entry that was written in a review; both null: none.
struct ReviewWriting {
    const Decision* decision = nullptr;  ///< a note, or an entry on a find
    const CandidateSample* dismissal = nullptr;
    explicit operator bool() const { return decision != nullptr || dismissal != nullptr; }
};
/// Returns the newest entry of any review of @p mission that is not taken back, one of both kinds. Never
/// returns what the mission recorded itself. Stays valid as long as @p mission.
[[nodiscard]] ReviewWriting newestWriting(const MissionState& mission);

}  // namespace leitstand
