#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/services/places/sensor_poses.h"
#include "core/event/event.h"
#include "core/event/map_samples.h"
#include "core/mapping/motion/motion_buffer.h"
#include "core/perception/pictures/picture_watch.h"
#include "core/perception/surroundings/virtual_scan.h"
#include "core/station/robot_view.h"
#include "core/station/sight_cap.h"

namespace leitstand {

/// What is around one robot: its virtual 2D scan out of what it said, and how old what its driver sees is.
/// What its scanners see waits for odometry that covers it, 150 ms at most; then its motion is guessed from
/// the last speed. Any thread.
class RobotSight {
public:
    explicit RobotSight(const RobotDescription& robot);

    void onEvent(const Event& event);  ///< what this robot said; what tells nothing here is passed by
    void onEvent(const Event& event, SteadyTime now);  ///< the same, as it came at another moment
    /// The same of a whole turn of the scanner, @p scan, that a station kept: where its slices are not at
    /// hand.
    void take(const KeyScanSample& scan, SteadyTime now);
    /// The driver looks through the camera @p sensor from now on, infrared or not; at first, through the one
    /// named first.
    void lookThrough(const std::string& sensor);
    /// How fast the robot may be driven where @p sticks lead.
    [[nodiscard]] SightCap cap(const DriveVelocity& sticks, bool withoutEyes) const;
    [[nodiscard]] SightCap cap(const DriveVelocity& sticks, bool withoutEyes, SteadyTime now) const;
    /// Fills cameras and joints.
    void tell(RobotView& robot) const;
    void tell(RobotView& robot, SteadyTime now) const;
    /// As seen from where the robot was by its newest odometry; ages run on while nothing comes. Empty before
    /// any odometry. Sectors' ages are on the robot's clock.
    [[nodiscard]] std::optional<VirtualScanView> view() const;
    [[nodiscard]] std::optional<VirtualScanView> view(SteadyTime now) const;

    /// When anything of a scan came last; none: never.
    [[nodiscard]] std::optional<SteadyTime> scanned() const;
    /// How far the robot can drive straight ahead until it touches something, at most 2 m; NaN where that was
    /// not looked at within 10 s.
    [[nodiscard]] double spaceAhead() const;

private:
    /// What a scanner saw, and when it came.
    struct Held {
        Event event;
        SteadyTime came = {};
    };
    void takePicture(const Event& event, const PictureSample& picture, SteadyTime now);  ///< under the mutex
    void takeOdometry(OdometrySample odometry, SteadyTime now);                          ///< likewise
    void placeHeld(SteadyTime now);                                                      ///< likewise
    void place(const Held& held);                                                        ///< likewise
    [[nodiscard]] std::optional<VirtualScanView> look(SteadyTime now) const;             ///< likewise
    /// Whether the odometry began anew since the newest that came.
    [[nodiscard]] bool hasLeapt(const OdometrySample& odometry, Time stamp) const;
    void addLasers(VirtualScanView& view, SteadyTime now) const;  ///< likewise
    [[nodiscard]] const PictureWatch* driversPicture() const;     ///< likewise; null: none came

    const BodyBox m_body;
    mutable std::mutex m_mutex;
    SensorPoses m_poses;
    VirtualScan m_scan;
    MotionBuffer m_motion;           ///< level as the odometry says
    std::deque<Held> m_held;         ///< that wait for odometry, as they came
    std::optional<Time> m_begun;     ///< robot's clock: what is older is of an odometry before this one
    std::optional<Time> m_newest;    ///< odometry, robot's clock
    SteadyTime m_arrived = {};       ///< of it
    Pose m_base = Pose::Identity();  ///< in odom, then
    bool m_hasCamera = false, m_hasScanner = false;
    std::string m_driversCamera;                    ///< sensor
    std::map<std::string, PictureWatch> m_cameras;  ///< by sensor
    std::map<std::string, PictureWatch> m_thermal;  ///< likewise
    std::optional<SteadyTime> m_scanned;            ///< when anything of a scan came
    /// The newest turn of a plane laser.
    struct Laser {
        std::vector<Eigen::Vector3f> inOdom;  ///< [m]
        SteadyTime came = {};
    };
    std::map<std::string, Laser> m_lasers;  ///< by topic
    std::optional<JointSample> m_joints;
    SteadyTime m_jointsCame = {};
};

}  // namespace leitstand
