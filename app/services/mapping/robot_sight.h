#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
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

/// The surroundings of one robot: its virtual 2D scan from what it sent, and how old the driver's view is.
/// Scans wait for odometry that covers them, at most 150 ms. After that their motion is extrapolated from the
/// last speed. Any thread.
class RobotSight {
public:
    explicit RobotSight(const RobotDescription& robot);

    void onEvent(const Event& event);  ///< takes what this robot sent; ignores what is of no use here
    void onEvent(const Event& event, SteadyTime now);  ///< the same, received at another moment
    /// The same for a whole turn of the scanner, @p scan, that a station kept, when its slices are not at
    /// hand.
    void take(const KeyScanSample& scan, SteadyTime now);
    /// Sets the driver's camera to @p sensor, infrared or not; at first it is the one named first.
    void selectCamera(const std::string& sensor);
    /// Returns how fast the robot may be driven where @p sticks lead.
    [[nodiscard]] SightCap cap(const DriveVelocity& sticks, bool withoutEyes) const;
    [[nodiscard]] SightCap cap(const DriveVelocity& sticks, bool withoutEyes, SteadyTime now) const;
    /// Fills cameras and joints.
    void fillView(RobotView& robot) const;
    void fillView(RobotView& robot, SteadyTime now) const;
    /// The surroundings seen from where the robot was by its newest odometry; ages grow while nothing comes.
    /// Empty before any odometry. Sectors' ages are on the robot's clock.
    [[nodiscard]] std::optional<VirtualScanView> view() const;
    [[nodiscard]] std::optional<VirtualScanView> view(SteadyTime now) const;

    /// When a scan or a slice of one came last; empty: never.
    [[nodiscard]] std::optional<SteadyTime> scanned() const;
    /// Returns how far the robot can drive straight ahead until it touches something, at most 2 m. NaN when
    /// this was not looked at within 10 s.
    [[nodiscard]] double spaceAhead() const;

private:
    /// A scanner's sample, and when it came.
    struct Held {
        Event event;
        SteadyTime came = {};
    };
    void takePicture(const Event& event, const PictureSample& picture, SteadyTime now);  ///< under the mutex
    void takeOdometry(OdometrySample odometry, SteadyTime now);                          ///< under the mutex
    void placeHeld(SteadyTime now);                                                      ///< under the mutex
    void place(const Held& held);                                                        ///< under the mutex
    [[nodiscard]] std::optional<VirtualScanView> look(SteadyTime now) const;             ///< under the mutex
    /// Whether the odometry started again since its newest sample.
    [[nodiscard]] bool hasLeapt(const OdometrySample& odometry, Time stamp) const;
    void addLasers(VirtualScanView& view, SteadyTime now) const;  ///< under the mutex
    [[nodiscard]] const PictureWatch* driversPicture() const;     ///< under the mutex; null: no picture came

    const BodyBox m_body;
    mutable std::mutex m_mutex;
    SensorPoses m_poses;
    VirtualScan m_scan;
    MotionBuffer m_motion;           ///< level by the odometry
    std::deque<Held> m_held;         ///< wait for odometry, in order of arrival
    std::optional<Time> m_begun;     ///< robot's clock: older samples belong to an earlier odometry
    std::optional<Time> m_newest;    ///< newest odometry, robot's clock
    SteadyTime m_arrived = {};       ///< when that odometry came
    Pose m_base = Pose::Identity();  ///< in odom, at that time
    bool m_hasCamera = false, m_hasScanner = false;
    std::string m_driversCamera;                    ///< sensor
    std::map<std::string, PictureWatch> m_cameras;  ///< by sensor
    std::map<std::string, PictureWatch> m_thermal;  ///< by sensor
    std::optional<SteadyTime> m_scanned;            ///< when a scan or a slice of one came last
    /// The newest turn of a plane laser.
    struct Laser {
        std::vector<Eigen::Vector3f> inOdom;  ///< [m]
        SteadyTime came = {};
    };
    std::map<std::string, Laser> m_lasers;  ///< by topic
    std::shared_ptr<const JointSample> m_joints;
    SteadyTime m_jointsCame = {};
};

}  // namespace leitstand
