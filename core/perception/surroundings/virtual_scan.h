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
    int sectors = 180;         ///< number of directions in a view
    double memory = 12.0;      ///< older measurements are dropped [s]
    double range = 30.0;       ///< farther points are left out [m]
    BodyBox body;              ///< points within this box are on the robot itself
    double bodyMargin = 0.03;  ///< added to the box on all sides [m]
    /// Up to this distance from the scanner, points close to directions of the robot's own body are mixed
    /// pixels [m].
    double mixedWithin = 1.0;
    ProfileSettings profile;
};

/// Returns the pose of base_link in odometry's frame at a time; empty when it is not known.
using BaseInOdomAt = std::function<std::optional<Pose>(Time)>;

/// Virtual 2D scan (paper, section 2.3). It keeps two points of each vertical raw scan of a 3D scanner. The
/// farthest is the outer contour (walls). The nearest that is neither floor nor ceiling is the inner contour
/// (obstacles). The points move with the odometry, so the view is complete and current although a turn of the
/// scanner takes 2.3 s. Plane scanners can be added as well. Roll and pitch come from the odometry's pose, if
/// it has them. One thread at a time.
class VirtualScan {
public:
    explicit VirtualScan(const VirtualScanSettings& settings = {});

    /// Takes a cloud of a 3D scanner. @p sensorInBase: pose of the cloud's frame. Rows whose points all have
    /// the same heading are used as vertical raw scans. Other clouds are divided into raw scans by heading.
    /// This includes tilting scanners, whose rows spread to the sides and for which robots stand. Raw scans
    /// at times without odometry are left out.
    void add(const CloudSample& cloud, const Pose& sensorInBase, const BaseInOdomAt& baseInOdom);
    /// Takes a turn of a plane scanner. @p sensorInBase: pose of the scanner. Floor that a tilted scanner
    /// sees is no obstacle. Obstacles close to the robot are remembered after the scanner has passed them.
    void add(const RangesSample& ranges, const Pose& sensorInBase, const BaseInOdomAt& baseInOdom);

    /// Returns the view at @p now from the robot's pose @p baseInOdom.
    [[nodiscard]] VirtualScanView view(const Pose& baseInOdom, Time now) const;
    /// Stamp of the newest raw scan that was added; empty: none.
    [[nodiscard]] std::optional<Time> newest() const { return m_newest; }
    /// Drops everything: call when the odometry restarted.
    void clear();

private:
    /// The result of the last measurement in one direction of the odometry's frame.
    struct Ray {
        bool seen = false;
        Time at{};
        /// Outer point, or the end of the visible range; in odom [m].
        Eigen::Vector2d far = Eigen::Vector2d::Zero();
        bool echo = false;                                     ///< whether `far` is a measured point
        std::optional<Eigen::Vector2d> inner;                  ///< inner point in odom [m]
        double top = std::numeric_limits<double>::infinity();  ///< height of the obstacle's upper end [m]
        double bottom = 0.0;                                   ///< height of its lower end [m]
        double innerZ = 0.0;                                   ///< height of the inner point in odom [m] ...
        double innerRise = 0.0;  ///< ... and above the robot's ground when it was measured [m]
    };
    /// The previous raw scan. It supports points of the next one, and limits the directions between the two.
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
    /// Stores @p ray. @p look: when the scanner's current pass over that direction began; older measurements
    /// of it are replaced.
    void put(const Ray& ray, double heading, Time look);
    void clearBetween(double from, double to, Time look);
    /// Removes obstacles that the robot now stands on: a ramp that a plane scanner saw from afar, or a kerb
    /// onto which it drove. These are points at its body that are now in the plane of its wheels, and points
    /// that continue this surface.
    void forgetClimbed(const Pose& base);
    /// Whether the point @p inBase [m] is on the robot's own body.
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
