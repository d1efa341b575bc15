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
    double memory = 12.0;      ///< older looks are dropped [s]
    double range = 30.0;       ///< farther points are left out [m]
    BodyBox body;              ///< points within it are on the robot itself
    double bodyMargin = 0.03;  ///< added to it all around [m]
    /// Up to this distance from the scanner, points beside directions of the own body count as mixed [m].
    double mixedWithin = 1.0;
    ProfileSettings profile;
};

/// Returns the pose of base_link in odometry's frame at a time; empty when it is not known.
using BaseInOdomAt = std::function<std::optional<Pose>(Time)>;

/// Virtual 2D scan (paper, section 2.3). It holds two points of each vertical raw scan of a 3D scanner: the
/// farthest (outer contour: walls), and the nearest that is neither floor nor ceiling (inner contour:
/// obstacles). Odometry moves the points along, so that the scan is complete and current although a turn of
/// the scanner takes 2.3 s. It also takes plane scanners. Roll and pitch are those of the odometry's pose, if
/// it has them. One thread at a time.
class VirtualScan {
public:
    explicit VirtualScan(const VirtualScanSettings& settings = {});

    /// Takes a cloud of a 3D scanner; @p sensorInBase: pose of the cloud's frame. Rows whose points all lie
    /// in one direction are taken as vertical raw scans. All other clouds are cut into raw scans by
    /// direction, also those whose rows fan out to the sides: of a tilting scanner, for which robots stand.
    /// Raw scans at times without odometry are left out.
    void add(const CloudSample& cloud, const Pose& sensorInBase, const BaseInOdomAt& baseInOdom);
    /// Takes a turn of a plane scanner; @p sensorInBase: pose of the scanner. Floor that a tilted one sees is
    /// no obstacle. Obstacles close beside the robot are remembered when the scanner has passed them.
    void add(const RangesSample& ranges, const Pose& sensorInBase, const BaseInOdomAt& baseInOdom);

    /// Returns the view from the robot's pose @p baseInOdom at @p now.
    [[nodiscard]] VirtualScanView view(const Pose& baseInOdom, Time now) const;
    /// Stamp of the newest raw scan that was added; empty: none.
    [[nodiscard]] std::optional<Time> newest() const { return m_newest; }
    /// Drops everything: call when the odometry restarted.
    void clear();

private:
    /// What the last look in a direction of the odometry's frame found.
    struct Ray {
        bool seen = false;
        Time at{};
        Eigen::Vector2d far = Eigen::Vector2d::Zero();  ///< outer point, or the end of sight; in odom [m]
        bool echo = false;                              ///< whether far is a measured point
        std::optional<Eigen::Vector2d> inner;           ///< in odom [m]
        double top = std::numeric_limits<double>::infinity();  ///< height of the obstacle's upper end [m]
        double bottom = 0.0;                                   ///< height of its lower end [m]
        double innerZ = 0.0;                                   ///< height of inner in odom [m]
        double innerRise = 0.0;  ///< ... and over the robot's ground at that time [m]
    };
    /// The previous raw scan: supports points of the next one, and bounds the directions between the two.
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
    /// @p look: when the scanner began its current look in that direction; what it saw before is replaced.
    void put(const Ray& ray, double heading, Time look);
    void clearBetween(double from, double to, Time look);
    /// Drops obstacles that the robot now stands on: a ramp that a plane scanner saw from afar, or a kerb
    /// that it drove onto. These are the points at its body that are now in the plane of its wheels, and the
    /// points that continue this surface.
    void forgetClimbed(const Pose& base);
    /// Whether a point [m] is on the robot's own body.
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
