#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

using Information = Eigen::Matrix<double, 6, 6>;

/// Source of the relative pose of two key scans.
enum class LinkKind : std::uint8_t {
    Odometry,  ///< the robot's odometry and gyro between two successive scans
    Match,     ///< one scan was registered against another near it
    Loop,      ///< two scans that are far apart along the path were found to show the same place
    Operator,  ///< the operator aligned the two scans
    Gravity,   ///< which way is up in a scan
    Session,   ///< two runs or missions were joined
    Geo,       ///< a surveyed place
};
inline constexpr int LinkKindCount = 7;
[[nodiscard]] std::string toString(LinkKind kind);
/// Whether such a link rejoins parts of a map that drifted apart.
[[nodiscard]] constexpr bool closesLoop(LinkKind kind) {
    return kind == LinkKind::Loop || kind == LinkKind::Operator || kind == LinkKind::Session;
}

/// A measured relative pose of two key scans.
struct Link {
    std::uint64_t id = 0;            ///< within the mission, from 1
    std::uint64_t from = 0, to = 0;  ///< KeyScanSample::id
    Pose pose = Pose::Identity();    ///< of `to` in `from`
    /// Inverse covariance of linkError(): translation first [1/m^2], then rotation [1/rad^2], in the frame of
    /// `to`.
    Information information = Information::Identity();
    LinkKind kind = LinkKind::Match;
    std::string station;  ///< station that found it
    bool active = true;   ///< whether it counts in the computation of poses
};

/// Links that are valid from now on; a link replaces the one with the same id.
struct ScanLinksSample {
    Time stamp{};         ///< station's clock
    std::string station;  ///< station that found all of them
    std::vector<Link> links;
};

}  // namespace leitstand
