#pragma once

#include <string_view>

namespace leitstand {

struct CandidateSample;
struct Decision;
struct MissionState;

/// Title of a review's session in the log, and beginning of the names of stations that write reviews. They
/// distinguish such a session from sessions of the mission itself.
inline constexpr std::string_view ReviewTitle = "Review", ReviewStation = "review";

/// An entry that was written in a review. If both pointers are null, there is none.
struct ReviewWriting {
    const Decision* decision = nullptr;  ///< a note, or an entry about a find
    const CandidateSample* dismissal = nullptr;
    explicit operator bool() const { return decision != nullptr || dismissal != nullptr; }
};
/// Returns the newest entry of any review of @p mission that is not undone: a decision or a dismissal. Never
/// returns what the mission recorded itself. Valid as long as @p mission exists.
[[nodiscard]] ReviewWriting newestWriting(const MissionState& mission);

}  // namespace leitstand
