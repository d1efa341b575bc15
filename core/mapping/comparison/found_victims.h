#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// Largest distance at which a find can match a true victim: a person's length plus a map's error [m].
inline constexpr double FoundReach = 1.0;

/// How the recorded victims (finds) compare with the true victims. Each true victim matches at most one find.
struct FindsError {
    int finds = 0;                   ///< number of recorded victims
    double mean = 0.0, worst = 0.0;  ///< distance of matched finds from their victims, horizontally [m]
    int missed = 0;                  ///< number of true victims without a find
    int wrong = 0;  ///< finds near no true victim, or only near one that another find matches
    [[nodiscard]] int found() const { return finds - wrong; }
};

/// Matches each of @p finds with at most one of @p victims, within @p reach [m]; both are in the same frame
/// [m]. As many as possible are matched, with the smallest sum of distances (Hungarian method, Kuhn 1955).
/// Points that are not finite match none.
[[nodiscard]] FindsError compareFinds(std::span<const Eigen::Vector3d> finds,
                                      std::span<const Eigen::Vector3d> victims, double reach = FoundReach);

}  // namespace leitstand
