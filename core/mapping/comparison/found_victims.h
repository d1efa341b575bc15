#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// Largest distance between a find and a true victim that match: a person's length plus a map's error [m].
inline constexpr double FoundReach = 1.0;

/// How the filed victims (finds) compare with the true ones. Each true victim matches one find at most.
struct FindsError {
    int finds = 0;                   ///< filed victims
    double mean = 0.0, worst = 0.0;  ///< distance of matched finds to their victims, in the plane [m]
    int missed = 0;                  ///< true victims without a find
    int wrong = 0;  ///< finds that match no true victim, or only one that another find matches
    [[nodiscard]] int found() const { return finds - wrong; }
};

/// Matches each of @p finds with a victim of its own from @p victims (both in one frame [m]) within @p reach
/// [m]. The matches are as many as possible, and then as near as possible (Hungarian method, Kuhn 1955).
/// Points that are not finite match none.
[[nodiscard]] FindsError compareFinds(std::span<const Eigen::Vector3d> finds,
                                      std::span<const Eigen::Vector3d> victims, double reach = FoundReach);

}  // namespace leitstand
