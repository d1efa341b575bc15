#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

using Information = Eigen::Matrix<double, 6, 6>;

/// What tells how two key scans lie to each other.
enum class LinkKind : std::uint8_t {
    Odometry,  ///< the robot's odometry and gyro between two scans that followed each other
    Match,     ///< one scan was registered against another near it
    Loop,      ///< two scans that are far from each other along the way were found to see the same place
    Operator,  ///< the operator put them together
    Gravity,   ///< which way is up in a scan
    Session,   ///< two runs or missions were joined
    Geo,       ///< a place that was surveyed
};
inline constexpr int LinkKindCount = 7;
[[nodiscard]] std::string toString(LinkKind kind);
/// Whether such a link brings parts of a map together that came to be apart from each other.
[[nodiscard]] constexpr bool closesLoop(LinkKind kind) {
    return kind == LinkKind::Loop || kind == LinkKind::Operator || kind == LinkKind::Session;
}

/// What is known of how two key scans lie to each other.
struct Link {
    std::uint64_t id = 0;            ///< within the mission, from 1
    std::uint64_t from = 0, to = 0;  ///< KeyScanSample::id
    Pose pose = Pose::Identity();    ///< of `to` in `from`
    /// Inverse covariance of linkError(): translation first [1/m^2], then rotation [1/rad^2], in the frame of
    /// `to`.
    Information information = Information::Identity();
    LinkKind kind = LinkKind::Match;
    std::string station;  ///< that found it
    bool active = true;   ///< whether poses follow it
};

/// Links that hold from then on; one whose id is known takes the place of that one.
struct ScanLinksSample {
    Time stamp{};         ///< station's clock
    std::string station;  ///< of each of them
    std::vector<Link> links;
};

}  // namespace leitstand
