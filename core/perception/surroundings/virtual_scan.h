#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/perception/surroundings/near_obstacles.h"
#include "core/perception/surroundings/own_body_mask.h"
#include "core/perception/surroundings/scan_profile.h"
#include "core/perception/surroundings/virtual_scan_view.h"

namespace leitstand {

struct CloudSample;
struct RangesSample;

/// Settings of a virtual scan.
struct VirtualScanSettings {
    int sectors = 180;         ///< directions in a view
    double memory = 12.0;      ///< what is older is forgotten [s]
    double range = 30.0;       ///< farther points are left out [m]
    BodyBox body;              ///< points within it are the robot's own
    double bodyMargin = 0.03;  ///< added to it all around [m]
    double mixedWithin = 1.0;  ///< points so near beside those on the own body are mixed with them [m]
    ProfileSettings profile;
};

/// Returns base_link in the odometry's frame at a time; empty when it is not known.
using BaseInOdomAt = std::function<std::optional<Pose>(Time)>;

/// Virtual 2D scan (paper, section 2.3). It holds two points of each vertical raw scan of a 3D scanner: the
/// farthest (outer contour: walls), and the nearest that is neither floor nor ceiling (inner contour:
/// obstacles). Odometry moves it along, so that it is complete and current although a turn of the scanner
/// takes 2.3 s. It also takes plane scanners. The attitude in odometry is used where there is one. One thread
/// at a time.
class VirtualScan {
public:
    explicit VirtualScan(const VirtualScanSettings& settings = {});

    /// Takes a cloud of a 3D scanner; @p sensorInBase: the cloud's frame. Rows that look one way are vertical
    /// raw scans. Other clouds, and those whose rows fan out to the sides (a tilting scanner's, for which
    /// robots stand), are cut by direction. Raw scans at times without odometry are left out.
    void add(const CloudSample& cloud, const Pose& sensorInBase, const BaseInOdomAt& baseInOdom);
    /// Takes a turn of a plane scanner. Floor that it sees when it is tilted is no obstacle. Obstacles close
    /// beside the robot stay known when they come behind the scanner.
    void add(const RangesSample& ranges, const Pose& sensorInBase, const BaseInOdomAt& baseInOdom);

    /// Returns the view from @p baseInOdom at @p now.
    [[nodiscard]] VirtualScanView view(const Pose& baseInOdom, Time now) const;
    /// Stamp of the newest raw scan that was added; empty: none.
    [[nodiscard]] std::optional<Time> newest() const { return m_newest; }
    /// Forgets everything: the odometry restarted.
    void clear();

private:
    /// A direction in the odometry's frame, at its last look.
    struct Ray {
        bool seen = false;
        Time at{};
        Eigen::Vector2d far = Eigen::Vector2d::Zero();  ///< outer point, or the end of sight; in odom [m]
        bool echo = false;                              ///< whether far is a point
        std::optional<Eigen::Vector2d> inner;           ///< in odom [m]
        double top = std::numeric_limits<double>::infinity();  ///< height of the obstacle's upper end [m]
        double bottom = 0.0;                                   ///< height of its lower end [m]
        double innerZ = 0.0;                                   ///< of inner, in odom [m]
        double innerRise = 0.0;                                ///< ... over the robot's ground then [m]
    };
    /// The previous raw scan, for support and for the directions between.
    struct Before {
        std::vector<ProfilePoint> points;
        double heading = 0.0;  ///< in odom [rad]
        Time at{};
    };
    void addProfile(std::vector<ProfilePoint> points, const Pose& base, const Eigen::Vector3d& scanner,
                    Time at);
    void remember(std::span<const ProfilePoint> points, const Ray& ray, const Eigen::Vector2d& origin,
                  double heading);
    static void addObstacle(VirtualScanView& view, const VirtualObstacle& one);
    /// @p look: when the scanner began its current look round; what it saw before is replaced.
    void put(const Ray& ray, double heading, Time look);
    void clearBetween(double from, double to, Time look);
    /// Forgets what the robot stands on, which looked like an obstacle from afar: a ramp, by a plane scanner,
    /// or a kerb that it got onto after all. These are the points that have sunk into the plane of its wheels
    /// at its body, and their continuation.
    void forgetClimbed(const Pose& base);
    /// Whether a point is one of the robot's own body [m].
    [[nodiscard]] bool isOwn(const Eigen::Vector3d& inBase) const;
    [[nodiscard]] int binOf(double heading) const;

    VirtualScanSettings m_settings;
    std::vector<Ray> m_rays;  ///< by heading in odom
    OwnBodyMask m_ownBody;
    NearObstacles m_near;
    std::optional<Before> m_before;
    std::optional<Time> m_newest;
};

}  // namespace leitstand
