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

/// The evidence for a find and its place, recorded when the operator presses the button.
struct FrozenEvidence {
    Time found{};                                              ///< when it was recorded, station's clock
    std::string robot;                                         ///< robot that saw it
    bool autonomous = false;                                   ///< whether the robot was driving itself
    std::uint64_t scan = 0;                                    ///< key scan that it belongs to; 0: none
    Eigen::Vector3d positionInScan = Eigen::Vector3d::Zero();  ///< position in that scan's frame [m]
    Eigen::Vector3d positionInMap = Eigen::Vector3d::Zero();   ///< position in the map [m]
    double deviation = Unknown;                                ///< standard deviation of the position [m]
    double heat = Unknown;                                     ///< temperature of the hot spot [degrees C]
    double co2 = Unknown;                                      ///< CO2 where it rose [ppm]
    bool motion = false;                                       ///< whether something moved there
    std::string tag;                                           ///< content of a code, or kind of a sign
    std::vector<VictimEvidence> evidence;
};

/// Standard deviation of a place that a person pointed at [m].
inline constexpr double PointedDeviation = 0.2;
/// Height of a body's middle above the ground, when it is unknown [m].
inline constexpr double LyingHeight = 0.2;

/// Returns the place in the map [m] of a find if a person points at the floor. Its height is @p height (in
/// the map [m]) if that is less than 2 m above the floor. Otherwise it is @ref LyingHeight above the floor.
[[nodiscard]] Eigen::Vector3d aboveFloor(const Eigen::Vector3d& floorInMap,
                                         std::optional<double> height = std::nullopt);

/// Places @p frozen at @p inMap [m] and attaches it to the key scan @p scan. If @p state has no such scan,
/// @p frozen stays attached to its previous scan.
void hang(FrozenEvidence& frozen, const MissionState& state, std::uint64_t scan,
          const Eigen::Vector3d& inMap);
/// Returns the key scan to which a find at @p inMap [m] shall be attached; 0: none. @p robot sees the find,
/// or a person points at it. First choice: the newest certain scan of @p robot, if it was taken within 4 m.
/// Second choice: the nearest certain scan (in an older part of the map, or for a robot without key scans).
/// Without certain scans: the newest undecided scan of @p robot, otherwise of any robot.
[[nodiscard]] std::uint64_t scanBeside(const MissionState& state, const std::string& robot,
                                       const Eigen::Vector3d& inMap);

/// Finds nearer to each other than this are the same find [m].
inline constexpr double SameFind = 0.6;
/// A candidate within this distance of a discarded find is the same thing [m].
inline constexpr double SameDiscarded = 0.35;
/// Finds with the same tag or text within this distance are the same find [m].
inline constexpr double SameNamed = 1.2;

/// Least confidence at which a candidate is shown to people.
inline constexpr double LeastShownConfidence = 0.5;

/// Returns the number of the next find of @p kind: one more than the highest so far, including undone finds.
[[nodiscard]] std::uint32_t nextNumber(const MissionState& state, FindSample::Kind kind);
/// Returns the find of @p kind nearest to @p placeInMap [m] within @p reach [m]; empty: none. Ignores
/// discarded finds, and codes and hazard signs whose text is not @p tag.
[[nodiscard]] std::optional<FindKey> findNear(const MissionState& state, FindSample::Kind kind,
                                              const Eigen::Vector3d& placeInMap, const std::string& tag = {},
                                              double reach = SameFind);

/// Returns the text of the sign of @p candidate, or of the code beside it; empty: nothing was read.
[[nodiscard]] std::string tagOf(const CandidateSample& candidate);
/// Whether @p candidate was filed, or is at the place of a find of its kind that may have the same text.
/// Discarded finds are included. If so, the candidate is not shown beside the find.
[[nodiscard]] bool isFiled(const MissionState& state, const CandidateSample& candidate);

/// Returns a new find made from @p frozen. If the find already exists at that place, returns it with what
/// @p frozen adds.
[[nodiscard]] FindSample filed(const MissionState& state, FindSample::Kind kind, const FrozenEvidence& frozen,
                               const std::string& station, Time now);
/// Returns the find that @p candidate becomes when the operator files it, at its place. @p seen: what was
/// seen there at that moment. Robot and mode come from the first report of @p candidate; if they are unknown
/// there, from the present.
[[nodiscard]] FindSample filedFrom(const MissionState& state, const CandidateSample& candidate,
                                   const std::string& station, Time now, const FrozenEvidence& seen = {});
/// Returns the shown candidates of @p kind within @ref SameFind of @p placeInMap [m] that belong to no find,
/// nearest first. Leaves out codes and hazard signs whose text differs from that of the nearest one.
[[nodiscard]] std::vector<CandidateSample> candidatesNear(const MissionState& state, FindSample::Kind kind,
                                                          const Eigen::Vector3d& placeInMap);
/// Adds what the cues of @p candidate show to @p frozen, where @p frozen has nothing yet.
void addCues(FrozenEvidence& frozen, const CandidateSample& candidate);
/// Returns @p candidate as filed under @p number.
[[nodiscard]] CandidateSample filedAs(CandidateSample candidate, std::uint32_t number,
                                      const std::string& station, Time now);

/// Returns the find with the status @p status, as an entry for the log; empty when the mission has no such
/// find.
[[nodiscard]] std::optional<FindSample> withStatus(const MissionState& state, const FindKey& find,
                                                   FindSample::Status status, const std::string& station,
                                                   Time now);
/// Another find of the same kind, and how far it is.
struct NearFind {
    FindKey find;
    double distance = 0.0;  ///< [m]
};
/// Largest distance at which two unnamed finds are merged: longer than a lying person [m].
constexpr double MergeReach = 2.0;
/// Returns the nearest other find of the same kind as @p find; empty: there is none. Ignores discarded finds.
[[nodiscard]] std::optional<NearFind> nearestOfKind(const MissionState& state, const FindKey& find);
/// Returns the find @p into after @p find of the same kind was merged into it; @p find is then discarded.
/// Empty when the mission lacks one of them, or when @p into is discarded.
[[nodiscard]] std::optional<FindSample> mergedInto(const MissionState& state, const FindKey& find,
                                                   std::uint32_t into, const std::string& station, Time now);
/// Returns @p find moved to aboveFloor() of @p floorInMap [m]; it stays attached to its scan. Empty when the
/// mission has no such find.
[[nodiscard]] std::optional<FindSample> movedTo(const MissionState& state, const FindKey& find,
                                                const Eigen::Vector3d& floorInMap, const std::string& station,
                                                Time now);

/// Returns the find with the kind and number of @p form, with the operator's entries in @p form: signs,
/// situation, tag, area, text. Empty when the mission has no such find.
[[nodiscard]] std::optional<FindSample> filledIn(const MissionState& state, const FindSample& form,
                                                 const std::string& station, Time now);

/// Returns @p newest with the operator's changes from @p before to @p after. @p before may be an older
/// version of the find than @p newest.
[[nodiscard]] FindSample withEdits(FindSample newest, const FindSample& before, const FindSample& after);

/// Returns @p find with what was added by finds merged into it: signs, situation, tag, evidence. Empty when
/// the mission has no such find.
[[nodiscard]] std::optional<FindSample> wholeFind(const MissionState& state, const FindKey& find);

}  // namespace leitstand
