#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

using Information = Eigen::Matrix<double, 6, 6>;

/// How the relative pose of two key scans is known.
enum class LinkKind : std::uint8_t {
    Odometry,  ///< from the robot's odometry and gyro between two consecutive scans
    Match,     ///< one scan was registered against another scan nearby
    Loop,      ///< two scans far apart along the path show the same place
    Operator,  ///< the operator aligned the two scans
    Gravity,   ///< gravity: which direction is up in a scan
    Session,   ///< two runs or missions are joined
    Geo,       ///< a surveyed position
};
inline constexpr int LinkKindCount = 7;
[[nodiscard]] std::string toString(LinkKind kind);
/// Whether a link of this kind rejoins parts of a map that drifted apart.
[[nodiscard]] constexpr bool closesLoop(LinkKind kind) {
    return kind == LinkKind::Loop || kind == LinkKind::Operator || kind == LinkKind::Session;
}

/// A measured relative pose of two key scans.
struct Link {
    std::uint64_t id = 0;            ///< id within the mission, from 1
    std::uint64_t from = 0, to = 0;  ///< KeyScanSample::id
    Pose pose = Pose::Identity();    ///< pose of scan `to` in the frame of scan `from`
    /// Inverse covariance of linkError(), in the frame of `to`: translation [1/m^2], then rotation [1/rad^2].
    Information information = Information::Identity();
    LinkKind kind = LinkKind::Match;
    std::string station;  ///< station that found it
    bool active = true;   ///< whether it is used to compute poses
};

/// Links that are valid from now on. A link replaces an earlier link with the same id.
struct ScanLinksSample {
    Time stamp{};         ///< station's clock
    std::string station;  ///< station that found all of them
    std::vector<Link> links;
};

}  // namespace leitstand
