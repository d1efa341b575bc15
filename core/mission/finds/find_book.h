#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// What was frozen when the operator pressed the button: everything that shows a find, and where it is.
struct FrozenEvidence {
    Time found{};                                              ///< station's clock
    std::string robot;                                         ///< that saw it
    bool autonomous = false;                                   ///< it drove itself
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

/// A place that a person pointed to is right within this, one standard deviation [m].
inline constexpr double PointedDeviation = 0.2;
/// Of a body's middle above the ground, where the height is not told [m].
inline constexpr double LyingHeight = 0.2;

/// Where a find is that a person points to on the floor of the map [m]: as high as it was before (@p height,
/// in the map [m]) where that is above this floor and below the next, else as a body lies.
[[nodiscard]] Eigen::Vector3d aboveFloor(const Eigen::Vector3d& floorInMap,
                                         std::optional<double> height = std::nullopt);

/// Puts @p frozen to @p inMap [m], hanging on key scan @p scan; on none where @p state does not have that.
void hang(FrozenEvidence& frozen, const MissionState& state, std::uint64_t scan,
          const Eigen::Vector3d& inMap);
/// The key scan that a find at @p inMap [m] hangs on, which @p robot sees or a person points to. It is that
/// robot's newest one that counts, where it was taken near enough to show the place. Else it is the nearest
/// one that counts: in an older part of the map, or of a robot without key scans. Where none counts: the
/// newest of that robot, or of anybody, that is not set aside; 0: none.
[[nodiscard]] std::uint64_t scanBeside(const MissionState& state, const std::string& robot,
                                       const Eigen::Vector3d& inMap);

/// Finds nearer than this to each other are one [m].
inline constexpr double SameFind = 0.6;
/// ... of what was discarded: what is farther away is another thing [m].
inline constexpr double SameDiscarded = 0.35;
/// ... of what bears the same tag or text, and is only placed otherwise [m].
inline constexpr double SameNamed = 1.2;

/// Confidence from which a candidate is shown to people.
inline constexpr double LeastShownConfidence = 0.5;

/// The number that the next find of @p kind gets: one above all that ever were, also undone ones.
[[nodiscard]] std::uint32_t nextNumber(const MissionState& state, VictimSample::Kind kind);
/// The find of @p kind that is nearest to @p placeInMap [m] and within @p reach [m]; not a discarded one, nor
/// a code or a hazard sign that says something else than @p tag.
[[nodiscard]] std::optional<FindKey> findNear(const MissionState& state, VictimSample::Kind kind,
                                              const Eigen::Vector3d& placeInMap, const std::string& tag = {},
                                              double reach = SameFind);

/// What the sign of @p candidate says, or the code beside it; empty: nothing was read.
[[nodiscard]] std::string tagOf(const CandidateSample& candidate);
/// Whether @p candidate was filed, or is where something of its kind was filed that may say what it says,
/// also what was discarded since: then it is not shown beside that.
[[nodiscard]] bool isFiled(const MissionState& state, const CandidateSample& candidate);

/// A new find made of @p frozen, or the one that is there already with what is new.
[[nodiscard]] VictimSample filed(const MissionState& state, VictimSample::Kind kind,
                                 const FrozenEvidence& frozen, const std::string& station, Time now);
/// What @p candidate becomes when the operator files it, with what was @p seen there at that moment; its
/// place is the candidate's, its robot and mode are those that told it first, else those of now.
[[nodiscard]] VictimSample filedFrom(const MissionState& state, const CandidateSample& candidate,
                                     const std::string& station, Time now, const FrozenEvidence& seen = {});
/// The candidates of @p kind that are shown within @ref SameFind of @p placeInMap [m] and are no other find,
/// nearest first; of codes and hazard signs those that say what the nearest does.
[[nodiscard]] std::vector<CandidateSample> candidatesNear(const MissionState& state, VictimSample::Kind kind,
                                                          const Eigen::Vector3d& placeInMap);
/// Adds to @p frozen what @p candidate's cues tell beyond it.
void addCues(FrozenEvidence& frozen, const CandidateSample& candidate);
/// @p candidate as what was filed as @p number.
[[nodiscard]] CandidateSample filedAs(CandidateSample candidate, std::uint32_t number,
                                      const std::string& station, Time now);

/// Changes of a find, each an entry for the log; empty when the mission does not have it.
[[nodiscard]] std::optional<VictimSample> withStatus(const MissionState& state, const FindKey& find,
                                                     VictimSample::Status status, const std::string& station,
                                                     Time now);
/// Another find of the same kind, and how far it is.
struct NearFind {
    FindKey find;
    double distance = 0.0;  ///< [m]
};
/// Farther apart, two finds are not merged without being named: longer than anybody lies [m].
constexpr double MergeReach = 2.0;
/// The one nearest to @p find of its kind that is not discarded; empty when there is none.
[[nodiscard]] std::optional<NearFind> nearestOfKind(const MissionState& state, const FindKey& find);
/// @p find is part of @p into, which is of its kind.
[[nodiscard]] std::optional<VictimSample> mergedInto(const MissionState& state, const FindKey& find,
                                                     std::uint32_t into, const std::string& station,
                                                     Time now);
/// @p find is where the floor is at @p floorInMap [m], @ref aboveFloor; it hangs on the scan that it hung on.
[[nodiscard]] std::optional<VictimSample> movedTo(const MissionState& state, const FindKey& find,
                                                  const Eigen::Vector3d& floorInMap,
                                                  const std::string& station, Time now);

/// The find of @p form's number with what an operator fills in (signs, situation, tag, area, text) of @p
/// form.
[[nodiscard]] std::optional<VictimSample> filledIn(const MissionState& state, const VictimSample& form,
                                                   const std::string& station, Time now);

/// @p newest with what an operator fills in as @p after has it, where that is another than @p before has: the
/// form may have been filled in over what was known long ago.
[[nodiscard]] VictimSample withEdits(VictimSample newest, const VictimSample& before,
                                     const VictimSample& after);

/// @p find with what the finds that were merged into it tell beyond it: signs, situation, tag, evidence;
/// empty when the mission does not have it.
[[nodiscard]] std::optional<VictimSample> wholeFind(const MissionState& state, const FindKey& find);

}  // namespace leitstand
