#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/services/places/sensor_poses.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/mapping/motion/motion_buffer.h"
#include "core/perception/pictures/picture_watch.h"
#include "core/perception/surroundings/virtual_scan.h"
#include "core/station/robot_view.h"
#include "core/station/sight_cap.h"

namespace leitstand {

struct PictureSample;
struct KeyScanSample;

/// The surroundings of one robot, from what it sent: its virtual 2D scan, and the age of the driver's view.
/// Scans wait for odometry of their time, but at most 150 ms. Then the robot's motion is extrapolated from
/// its last speed. Any thread.
class RobotSight {
public:
    explicit RobotSight(const RobotDescription& robot);

    void onEvent(const Event& event);  ///< takes what this robot sent; ignores events that it does not need
    void onEvent(const Event& event, SteadyTime now);  ///< as above, for an event received at @p now
    /// Takes a whole turn of the scanner that a station stored as the key scan @p scan, received at @p now.
    /// Used for missions without the slices of that turn.
    void take(const KeyScanSample& scan, SteadyTime now);
    /// Selects the driver's camera @p sensor, which may be infrared. At first it is the first camera in the
    /// robot's file, an infrared one only if there is no other.
    void selectCamera(const std::string& sensor);
    /// Returns the limit on the robot's speed in the direction of @p sticks, given the age of what the driver
    /// sees there. @p withoutEyes: whether the operator drives without a view.
    [[nodiscard]] SightCap cap(const DriveVelocity& sticks, bool withoutEyes) const;
    [[nodiscard]] SightCap cap(const DriveVelocity& sticks, bool withoutEyes, SteadyTime now) const;
    /// Sets cameras, joints and scanners without a place of @p robot.
    void fillView(RobotView& robot) const;
    void fillView(RobotView& robot, SteadyTime now) const;
    /// Returns the surroundings as seen from the robot's pose in its newest odometry; empty before any
    /// odometry. Ages increase while nothing arrives. Ages of sectors are on the robot's clock.
    [[nodiscard]] std::optional<VirtualScanView> view() const;
    [[nodiscard]] std::optional<VirtualScanView> view(SteadyTime now) const;

    /// Returns when a scan, or a slice of a scan, last arrived; empty: never.
    [[nodiscard]] std::optional<SteadyTime> scanned() const;
    /// Returns how far the robot can drive straight ahead before it touches something, at most 2 [m]. NaN
    /// when the space ahead was not scanned within the last 10 s.
    [[nodiscard]] double spaceAhead() const;

private:
    /// A scanner's sample, and when it arrived.
    struct Held {
        Event event;
        SteadyTime came = {};
    };
    void takePicture(const Event& event, const PictureSample& picture, SteadyTime now);  ///< under the mutex
    void takeOdometry(const OdometrySample& odometry, SteadyTime now);                   ///< under the mutex
    void placeHeld(SteadyTime now);                                                      ///< under the mutex
    void place(const Held& held);                                                        ///< under the mutex
    [[nodiscard]] std::optional<VirtualScanView> look(SteadyTime now) const;             ///< under the mutex
    /// Whether @p odometry, taken at @p stamp, shows that the robot's odometry has restarted.
    [[nodiscard]] bool hasLeapt(const OdometrySample& odometry, Time stamp) const;
    void addLasers(VirtualScanView& view, SteadyTime now) const;  ///< under the mutex
    [[nodiscard]] const PictureWatch* driversPicture() const;  ///< under the mutex; null: no picture arrived

    const BodyBox m_body;
    mutable std::mutex m_mutex;
    SensorPoses m_poses;
    VirtualScan m_scan;
    MotionBuffer m_motion;           ///< its level is that of the odometry
    std::deque<Held> m_held;         ///< samples that wait for odometry, in order of arrival
    std::optional<Time> m_begun;     ///< robot's clock; older samples belong to an earlier odometry
    std::optional<Time> m_newest;    ///< stamp of the newest odometry, robot's clock
    SteadyTime m_arrived = {};       ///< when that odometry arrived
    Pose m_base = Pose::Identity();  ///< base_link in odom at that time
    bool m_hasCamera = false, m_hasScanner = false;
    std::string m_driversCamera;                               ///< the driver's camera
    std::map<std::string, PictureWatch> m_cameras;             ///< by sensor
    std::map<std::string, PictureWatch> m_thermal;             ///< by sensor
    std::set<std::pair<std::string, std::string>> m_scanners;  ///< sensors and frames of clouds and turns
    std::optional<SteadyTime> m_scanned;  ///< when a scan or a slice of a scan last arrived
    /// The newest turn of a plane laser.
    struct Laser {
        std::vector<Eigen::Vector3f> inOdom;  ///< its points in odom [m]
        SteadyTime came = {};
    };
    std::map<std::string, Laser> m_lasers;  ///< by topic
    std::shared_ptr<const JointSample> m_joints;
    SteadyTime m_jointsCame = {};
};

}  // namespace leitstand
