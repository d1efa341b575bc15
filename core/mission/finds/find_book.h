#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// The evidence for a find and its place, frozen when the operator presses the button.
struct FrozenEvidence {
    Time found{};                                              ///< station's clock
    std::string robot;                                         ///< that saw it
    bool autonomous = false;                                   ///< the robot drove itself
    std::uint64_t scan = 0;                                    ///< key scan it hangs on; 0: none
    Eigen::Vector3d positionInScan = Eigen::Vector3d::Zero();  ///< in that scan's frame [m]
    Eigen::Vector3d positionInMap = Eigen::Vector3d::Zero();   ///< [m]
    double deviation = Unknown;                                ///< standard deviation of the position [m]
    double heat = Unknown;                                     ///< of the hot spot [degrees C]
    double co2 = Unknown;                                      ///< [ppm], where it rose
    bool motion = false;                                       ///< something moved there
    std::string tag;                                           ///< content of a code, or a sign's kind
    std::vector<VictimEvidence> evidence;
};

/// Standard deviation of a place that a person pointed to [m].
inline constexpr double PointedDeviation = 0.2;
/// Height of a body's middle above the ground, when it is unknown [m].
inline constexpr double LyingHeight = 0.2;

/// Returns the place, in the map [m], of a find that a person points to on the floor. It keeps @p height (in
/// the map [m]) when that is less than 2 m above this floor. Otherwise it is @ref LyingHeight above the
/// floor.
[[nodiscard]] Eigen::Vector3d aboveFloor(const Eigen::Vector3d& floorInMap,
                                         std::optional<double> height = std::nullopt);

/// Places @p frozen at @p inMap [m] and hangs it on key scan @p scan. When @p state has no such scan,
/// @p frozen stays on the scan that it had.
void hang(FrozenEvidence& frozen, const MissionState& state, std::uint64_t scan,
          const Eigen::Vector3d& inMap);
/// Returns the key scan on which to hang a find at @p inMap [m]; 0: none. @p robot sees the find, or a person
/// points to it. First choice is the newest scan of @p robot that counts, if it was taken within 4 m. Second
/// is the nearest scan that counts: in an older part of the map, or for a robot without key scans. If no scan
/// counts, it is the newest undecided scan of @p robot, otherwise of any robot.
[[nodiscard]] std::uint64_t scanBeside(const MissionState& state, const std::string& robot,
                                       const Eigen::Vector3d& inMap);

/// Finds nearer than this to each other are one [m].
inline constexpr double SameFind = 0.6;
/// A candidate nearer than this to a discarded find is that find [m].
inline constexpr double SameDiscarded = 0.35;
/// Distance within which finds with the same tag or text are one [m].
inline constexpr double SameNamed = 1.2;

/// Confidence from which a candidate is shown to people.
inline constexpr double LeastShownConfidence = 0.5;

/// Returns the number of the next find of @p kind: one above all so far, including undone ones.
[[nodiscard]] std::uint32_t nextNumber(const MissionState& state, FindSample::Kind kind);
/// Returns the find of @p kind nearest to @p placeInMap [m] within @p reach [m]; empty: none. Discarded finds
/// do not count, nor do codes and hazard signs with a text other than @p tag.
[[nodiscard]] std::optional<FindKey> findNear(const MissionState& state, FindSample::Kind kind,
                                              const Eigen::Vector3d& placeInMap, const std::string& tag = {},
                                              double reach = SameFind);

/// Returns the text of @p candidate's sign, or of the code beside it; empty: nothing was read.
[[nodiscard]] std::string tagOf(const CandidateSample& candidate);
/// Whether @p candidate was filed, or lies at a find of its kind that may have the same text. Discarded finds
/// count here, too. Such a candidate is not shown beside the find.
[[nodiscard]] bool isFiled(const MissionState& state, const CandidateSample& candidate);

/// Returns a new find made of @p frozen. If that find exists there already, returns it with what @p frozen
/// adds.
[[nodiscard]] FindSample filed(const MissionState& state, FindSample::Kind kind, const FrozenEvidence& frozen,
                               const std::string& station, Time now);
/// Returns the find that @p candidate becomes when the operator files it, at the place of @p candidate.
/// @p seen: what was seen there at that moment. Robot and mode are those of the first report of @p candidate,
/// otherwise those of now.
[[nodiscard]] FindSample filedFrom(const MissionState& state, const CandidateSample& candidate,
                                   const std::string& station, Time now, const FrozenEvidence& seen = {});
/// Returns the candidates of @p kind within @ref SameFind of @p placeInMap [m] that are shown and belong to
/// no find, nearest first. Codes and hazard signs with another text than the nearest one are left out.
[[nodiscard]] std::vector<CandidateSample> candidatesNear(const MissionState& state, FindSample::Kind kind,
                                                          const Eigen::Vector3d& placeInMap);
/// Adds what the cues of @p candidate show to @p frozen, as far as @p frozen lacks it.
void addCues(FrozenEvidence& frozen, const CandidateSample& candidate);
/// Returns @p candidate as filed under @p number.
[[nodiscard]] CandidateSample filedAs(CandidateSample candidate, std::uint32_t number,
                                      const std::string& station, Time now);

/// Returns the find with @p status, as an entry for the log; empty when the mission does not have it.
[[nodiscard]] std::optional<FindSample> withStatus(const MissionState& state, const FindKey& find,
                                                   FindSample::Status status, const std::string& station,
                                                   Time now);
/// Another find of the same kind, and how far it is.
struct NearFind {
    FindKey find;
    double distance = 0.0;  ///< [m]
};
/// Largest distance at which two finds are merged unless both are named: longer than anybody lies [m].
constexpr double MergeReach = 2.0;
/// Returns the nearest other find of the same kind as @p find; empty: there is none. Discarded finds do not
/// count.
[[nodiscard]] std::optional<NearFind> nearestOfKind(const MissionState& state, const FindKey& find);
/// Returns @p find merged into the find @p into of the same kind; @p find itself is then discarded. Empty
/// when the mission does not have both, or when @p into is discarded.
[[nodiscard]] std::optional<FindSample> mergedInto(const MissionState& state, const FindKey& find,
                                                   std::uint32_t into, const std::string& station, Time now);
/// Returns @p find moved to aboveFloor() of @p floorInMap [m], still on the scan that it hung on. Empty when
/// the mission does not have it.
[[nodiscard]] std::optional<FindSample> movedTo(const MissionState& state, const FindKey& find,
                                                const Eigen::Vector3d& floorInMap, const std::string& station,
                                                Time now);

/// Returns the find with the kind and number of @p form, and with the operator's entries in @p form: signs,
/// situation, tag, area, text. Empty when the mission does not have it.
[[nodiscard]] std::optional<FindSample> filledIn(const MissionState& state, const FindSample& form,
                                                 const std::string& station, Time now);

/// Returns @p newest with those of the operator's entries that differ between @p before and @p after.
/// @p before may be an older version of the find than @p newest.
[[nodiscard]] FindSample withEdits(FindSample newest, const FindSample& before, const FindSample& after);

/// Returns @p find with what the finds merged into it add: signs, situation, tag, evidence. Empty when the
/// mission does not have it.
[[nodiscard]] std::optional<FindSample> wholeFind(const MissionState& state, const FindKey& find);

}  // namespace leitstand
