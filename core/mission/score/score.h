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

/// How much a robot found by itself. Under the rules of 2019, what the station computes counts half.
enum class Autonomy : std::uint8_t {
    Teleoperated,
    Semi,  ///< the robot drove itself, but the station or the operator made the find
    Full,  ///< the robot drove itself and reported the find itself
};

/// A scored item of a victim.
struct ScoredItem {
    ScoreItem item = ScoreItem::Map;
    double points = 0.0;    ///< points that it gives now
    double possible = 0.0;  ///< points that it would give when reported
};

/// The points of a find.
struct ScoredFind {
    FindKey find;
    std::string name;               ///< "V1"
    bool confirmed = false;         ///< whether it is confirmed; others give no points yet
    std::vector<ScoredItem> items;  ///< only for victims
    double points = 0.0;            ///< points before weighting
    double weight = 1.0;            ///< weight of its area
    std::string unweighed;          ///< its area, if the profile has no weight for it; otherwise empty
    Autonomy autonomy = Autonomy::Teleoperated;
    double factor = 1.0;  ///< factor for its autonomy
    double total = 0.0;   ///< points x weight x factor
};

/// What the operator can do next, and the gain.
struct ScoreAdvice {
    FindKey find;
    std::string name;               ///< "V1"
    std::optional<ScoreItem> item;  ///< item to report; empty: confirm the find
    double gain = 0.0;              ///< points that the score gains
};

/// An estimate of the score that judges would give.
struct ScoreResult {
    std::vector<ScoredFind> finds;  ///< by kind and number; discarded finds are left out
    std::uint64_t areaBumps = 0, victimBumps = 0;
    double penalty = 0.0;  ///< penalty for bumps, positive
    std::uint32_t operators = 1;
    double divisor = 1.0;
    double sum = 0.0;                 ///< sum of the finds
    double score = 0.0;               ///< (sum - penalty) / divisor
    std::set<std::string> unweighed;  ///< areas of finds without a weight in the profile; they have weight 1
    std::vector<ScoreAdvice> advice;  ///< largest gain first
};

/// Estimates the score of @p state under the rules @p profile. The map is assumed to be good, because only
/// judges can rate it. A contact is a bump of a victim when the robot touches() a confirmed victim.
[[nodiscard]] ScoreResult score(const ScoreProfile& profile, const MissionState& state,
                                const Footprints& footprints = {});

/// Returns how far the robot found @p find by itself.
[[nodiscard]] Autonomy autonomyOf(const FindSample& find);

/// Returns the pose of the odometry frame of @p robot in the map at @p moment (station's clock); empty:
/// unknown. It comes from the robot's newest key scan up to @p moment that is not set aside. Before the first
/// such scan, it comes from the first one. If there is none, it comes from the newest reported place.
[[nodiscard]] std::optional<Pose> odomInMap(const MissionState& state, const std::string& robot, Time moment);

}  // namespace leitstand
