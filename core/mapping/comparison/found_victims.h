#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// A find farther from every true victim is none of them: longer than anybody lies, with a map's error [m].
inline constexpr double FoundReach = 1.0;

/// How filed victims compare with the true ones, each find with a victim of its own.
struct FindsError {
    int finds = 0;                   ///< filed victims
    double mean = 0.0, worst = 0.0;  ///< how far those that are one are off, in the plane [m]
    int missed = 0;                  ///< true victims that no find is
    int wrong = 0;                   ///< finds that are no victim, or one that another find is
    [[nodiscard]] int found() const { return finds - wrong; }
};

/// Gives each of @p finds a victim of its own of @p victims (both in one frame [m]) within @p reach [m]: as
/// many as can be, and then as near as can be (Hungarian method, Kuhn 1955). What is not finite is none.
[[nodiscard]] FindsError compareFinds(std::span<const Eigen::Vector3d> finds,
                                      std::span<const Eigen::Vector3d> victims, double reach = FoundReach);

}  // namespace leitstand
