#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/mission/score/score_profile.h"
#include "core/mission/score/touches.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

struct FindSample;

/// How far a robot found something by itself. The rules of 2019 count what the station computes as half.
enum class Autonomy : std::uint8_t {
    Teleoperated,
    Semi,  ///< the robot drove itself, but the station or the operator found it
    Full,  ///< the robot drove itself and reported it itself
};

/// A scored item of a victim.
struct ScoredItem {
    ScoreItem item = ScoreItem::Map;
    double points = 0.0;    ///< that it brings now
    double possible = 0.0;  ///< that it would bring when reported
};

/// The points of a find.
struct ScoredFind {
    FindKey find;
    std::string name;               ///< "V1"
    bool confirmed = false;         ///< unconfirmed finds bring nothing yet
    std::vector<ScoredItem> items;  ///< of victims only
    double points = 0.0;            ///< unweighted
    double weight = 1.0;            ///< of its area
    std::string unweighed;          ///< its area, when the profile has no weight for it; otherwise empty
    Autonomy autonomy = Autonomy::Teleoperated;
    double factor = 1.0;  ///< of its autonomy
    double total = 0.0;   ///< points x weight x factor
};

/// The gain of one more step.
struct ScoreAdvice {
    FindKey find;
    std::string name;               ///< "V1"
    std::optional<ScoreItem> item;  ///< to report; empty: confirm the find
    double gain = 0.0;              ///< points that the score gains
};

/// An estimate of what the judges give.
struct ScoreResult {
    std::vector<ScoredFind> finds;  ///< by kind and number, without discarded ones
    std::uint64_t areaBumps = 0, victimBumps = 0;
    double penalty = 0.0;  ///< of the bumps, positive
    std::uint32_t operators = 1;
    double divisor = 1.0;
    double sum = 0.0;                 ///< of the finds
    double score = 0.0;               ///< (sum - penalty) / divisor
    std::set<std::string> unweighed;  ///< areas of finds without a weight in the profile; they have weight 1
    std::vector<ScoreAdvice> advice;  ///< largest gain first
};

/// Estimates the score of @p state by @p profile. The map counts as good, because only judges can rate it. A
/// contact counts as a bump of a victim when the robot touches() a confirmed victim.
[[nodiscard]] ScoreResult score(const ScoreProfile& profile, const MissionState& state,
                                const Footprints& footprints = {});

/// Returns how far the robot found @p find by itself.
[[nodiscard]] Autonomy autonomyOf(const FindSample& find);

/// Returns the pose of the odometry frame of @p robot in the map at @p moment (station's clock); empty:
/// unknown. It comes from the robot's newest key scan up to @p moment that is not set aside. Before the first
/// such scan, it comes from that one; without any, from the newest reported place.
[[nodiscard]] std::optional<Pose> odomInMap(const MissionState& state, const std::string& robot, Time moment);

}  // namespace leitstand
