#include "app/services/mapping/robot_sight.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "app/services/log/sequencer.h"
#include "core/base/time.h"
#include "core/event/cloud_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/mapping/motion/motion_compensation.h"
#include "core/perception/pictures/video/video_packet.h"
#include "core/perception/surroundings/laser_points.h"
#include "core/perception/surroundings/robot_profile.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

constexpr std::size_t MostScanners = 16;                                    ///< whose places are judged
constexpr double SmearedBy = 0.3;                                           ///< of a turn, while driving [m]
constexpr std::chrono::nanoseconds LongestWait = std::chrono::seconds(10);  ///< in the queue
constexpr std::chrono::milliseconds LongestHeld(150);                       ///< for odometry
constexpr double Silence = 1.0;     ///< without odometry, after which a robot may have started again [s]
constexpr double Zero = 0.05;       ///< a robot that has just started is this near to it [m, rad]
constexpr double LaserShown = 2.0;  ///< after its turn came [s]; nothing of it is kept
constexpr double Elsewhere = 0.15;

VirtualScanSettings scanOf(const RobotDescription& robot) {
    VirtualScanSettings settings;
    settings.body = boxAround(robot.footprint);
    settings.profile = profileOf(robot);
    return settings;
}

/// Returns the points of @p scan with their times, as its scanner would have sent them in one cloud.
CloudSample cloudOf(const Scan& scan, Time end) {
    CloudSample cloud;
    cloud.points = scan.points;
    cloud.header.stamp = end;
    if (!scan.organised() || scan.sweep != Sweep::Yawing) return cloud;
    cloud.rows = scan.rows;
    cloud.columns = scan.columns;
    const auto took = scan.start == Time{} ? std::chrono::nanoseconds(0) : end - scan.start;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const auto after = static_cast<std::int64_t>(i) / scan.columns + 1 - scan.rows;
        cloud.times.push_back(after * (took.count() / scan.rows));
    }
    return cloud;
}

/// Returns the stamp of the last shot of a scanner's sample.
Time endOf(const Sample& sample) {
    if (const auto* cloud = sample.as<CloudSample>()) return leitstand::endOf(*cloud);
    const auto* const ranges = sample.as<RangesSample>();
    if (ranges == nullptr || ranges->ranges.empty()) return {};
    const double last = std::max(0.0, ranges->timeStep * double(ranges->ranges.size() - 1));
    return ranges->header.stamp + std::chrono::nanoseconds(static_cast<std::int64_t>(last * 1e9));
}

}  // namespace

RobotSight::RobotSight(const RobotDescription& robot)
    : m_body(boxAround(robot.footprint)), m_poses(robot), m_scan(scanOf(robot)) {
    const StreamDescription* camera = robot.stream(StreamRole::Picture);
    if (camera == nullptr) camera = robot.stream(StreamRole::Thermal);
    m_hasCamera = camera != nullptr;
    if (m_hasCamera) m_driversCamera = camera->sensor;
    m_hasScanner = std::any_of(robot.streams.begin(), robot.streams.end(),
                               [](const StreamDescription& one) { return isScanner(one.role); });
}

void RobotSight::onEvent(const Event& event) {
    // A sample that waited in the queue came earlier than it is taken: old pictures must not look fresh.
    const auto waited = std::clamp(stationTime() - event.received, std::chrono::nanoseconds(0), LongestWait);
    onEvent(event, std::chrono::steady_clock::now() - waited);
}

void RobotSight::onEvent(const Event& event, SteadyTime now) {
    const std::lock_guard lock(m_mutex);
    if (const auto* picture = event.sample.as<PictureSample>()) {
        takePicture(event, *picture, now);
    } else if (const auto* odometry = event.sample.as<OdometrySample>()) {
        m_poses.add(event);
        m_poses.forgetBefore(Time::max());  // m_motion holds them
        OdometrySample stamped = *odometry;
        if (stamped.header.stamp == Time{}) stamped.header.stamp = event.received;
        takeOdometry(stamped, now);
    } else if (const auto* imu = event.sample.as<ImuSample>()) {
        ImuSample turning;
        turning.header = imu->header;
        if (turning.header.stamp == Time{}) turning.header.stamp = event.received;
        turning.angularVelocity = imu->angularVelocity;
        m_motion.add(turning, m_poses.inBase(event.sensor, imu->header.frame));
    } else if (event.sample.is<CloudSample>() || event.sample.is<RangesSample>()) {
        const auto* const cloud = event.sample.as<CloudSample>();
        const std::string& frame =
            cloud != nullptr ? cloud->header.frame : event.sample.get<RangesSample>().header.frame;
        if (m_scanners.size() < MostScanners) m_scanners.emplace(event.sensor, frame);
        m_held.push_back({event, now});
    } else if (const auto* joints = event.sample.as<JointSample>();
               joints != nullptr && event.role == StreamRole::Joints) {
        m_joints = std::make_shared<const JointSample>(*joints);
        m_jointsCame = now;
    } else {
        m_poses.add(event);
    }
    placeHeld(now);
}

void RobotSight::takePicture(const Event& event, const PictureSample& picture, SteadyTime now) {
    if (picture.video && !picture.video->decodable()) return;  // the driver does not see it
    if (event.role == StreamRole::Picture) m_cameras[event.sensor].arrived(picture.content.bytes, now);
    if (event.role == StreamRole::Thermal) m_thermal[event.sensor].arrived(picture.content.bytes, now);
}

void RobotSight::takeOdometry(const OdometrySample& odometry, SteadyTime now) {
    const Time stamp = odometry.header.stamp;
    const Pose base = odometry.baseInOdom;
    const int jumps = m_motion.clockJumps();
    m_motion.add(odometry);
    const bool jumped = m_motion.clockJumps() != jumps;
    // A single stamp that does not fit is doubted until the next one agrees with it.
    if (!m_motion.covers(stamp) || (!jumped && m_newest && stamp < *m_newest)) return;
    // The robot started again, on a clock that jumped or on its own: its earlier surroundings are void.
    if (m_newest && (jumped || hasLeapt(odometry, stamp))) {
        m_scan.clear();
        m_lasers.clear();
        m_held.clear();
        m_begun = stamp;
    }
    m_newest = stamp;
    m_arrived = now;
    m_base = base;
}

void RobotSight::placeHeld(SteadyTime now) {
    while (!m_held.empty()) {
        const Held& next = m_held.front();
        const bool waited = now - next.came >= LongestHeld || now < next.came;
        if (!waited && !m_motion.covers(endOf(next.event.sample))) return;
        place(next);
        m_held.pop_front();
    }
}

void RobotSight::place(const Held& held) {
    m_scanned = held.came;
    const Event& event = held.event;
    const auto base = [this](Time at) -> std::optional<Pose> {
        if (m_begun && at < *m_begun) return std::nullopt;
        const auto motion = m_motion.at(at);
        if (!motion || motion->source == MotionSource::Bridged) return std::nullopt;
        return motion->baseInOdom;
    };
    if (const auto* cloud = event.sample.as<CloudSample>()) {
        m_scan.add(*cloud, m_poses.inBase(event.sensor, cloud->header.frame), base);
    } else if (const auto* ranges = event.sample.as<RangesSample>()) {
        const Pose laser = m_poses.inBase(event.sensor, ranges->header.frame);
        m_scan.add(*ranges, laser, base);
        m_lasers[event.topic] = {laserPoints(*ranges, laser, base), held.came};
    }
}

bool RobotSight::hasLeapt(const OdometrySample& odometry, Time stamp) const {
    const double since = toSeconds(stamp - *m_newest);
    const Pose& now = odometry.baseInOdom;
    if (since < 0.0 || !now.matrix().allFinite()) return false;
    // After a silence it may have moved far. But a robot that started again is where its odometry is zero.
    const bool atZero =
        distanceBetween(Pose::Identity(), now) < Zero && angleBetween(Pose::Identity(), now) < Zero;
    const bool wasElsewhere =
        distanceBetween(m_base, now) > Elsewhere || angleBetween(m_base, now) > Elsewhere;
    return leaps(m_base, now, since) || (since > Silence && atZero && wasElsewhere);
}

void RobotSight::take(const KeyScanSample& sample, SteadyTime now) {
    if (!sample.scan || !sample.scan->hasOdometry) return;
    const Scan& scan = *sample.scan;
    // The points are free of motion: all are seen from where the robot was at the end.
    const Pose baseThen = scan.sensorInOdom * sample.sensorInBase.inverse();
    CloudSample cloud = cloudOf(scan, scan.end == Time{} ? sample.stamp : scan.end);
    // This smears the robot's own edges: points this near cannot be distinguished from them.
    const BodyBox edges = m_body.grown(SmearedBy);
    for (Eigen::Vector3f& point : cloud.points) {
        const Eigen::Vector3d inBase = sample.sensorInBase * point.cast<double>();
        if (edges.contains(inBase.head<2>())) point.setConstant(std::numeric_limits<float>::quiet_NaN());
    }
    const std::lock_guard lock(m_mutex);
    m_scanned = now;
    m_scan.add(cloud, sample.sensorInBase, [&baseThen](Time) { return std::optional(baseThen); });
}

void RobotSight::selectCamera(const std::string& sensor) {
    const std::lock_guard lock(m_mutex);
    m_driversCamera = sensor;
}

SightCap RobotSight::cap(const DriveVelocity& sticks, bool withoutEyes) const {
    return cap(sticks, withoutEyes, std::chrono::steady_clock::now());
}

SightCap RobotSight::cap(const DriveVelocity& sticks, bool withoutEyes, SteadyTime now) const {
    const std::lock_guard lock(m_mutex);
    SightAges ages;
    ages.camera = m_hasCamera;
    ages.scanner = m_hasScanner;
    if (const PictureWatch* const watch = driversPicture()) ages.picture = watch->at(now);
    if (m_scanned) ages.scan = secondsBetween(*m_scanned, now);
    // The surroundings take long to compute: only where it matters.
    const SightRules rules;
    if (ages.picture.seconds() >= rules.full && ages.scan < rules.creep) {
        if (const auto view = look(now)) ages.ahead = scanAgeAlong(*view, sticks);
    }
    return sightCap(ages, withoutEyes, rules);
}

const PictureWatch* RobotSight::driversPicture() const {
    for (const auto* cameras : {&m_cameras, &m_thermal}) {
        if (const auto camera = cameras->find(m_driversCamera); camera != cameras->end())
            return &camera->second;
    }
    return nullptr;
}

void RobotSight::fillView(RobotView& robot) const {
    fillView(robot, std::chrono::steady_clock::now());
}

void RobotSight::fillView(RobotView& robot, SteadyTime now) const {
    const std::lock_guard lock(m_mutex);
    for (const auto& [sensor, watch] : m_cameras) robot.cameras.push_back({sensor, watch.at(now)});
    for (const auto& [sensor, frame] : m_scanners)
        if (!m_poses.isPlaced(sensor, frame)) robot.unplaced.push_back(frame);
    robot.joints = m_joints;
    if (m_joints) robot.jointsAge = secondsBetween(m_jointsCame, now);
}

std::optional<VirtualScanView> RobotSight::view() const {
    return view(std::chrono::steady_clock::now());
}

std::optional<VirtualScanView> RobotSight::view(SteadyTime now) const {
    const std::lock_guard lock(m_mutex);
    auto view = look(now);
    if (view) addLasers(*view, now);
    return view;
}

void RobotSight::addLasers(VirtualScanView& view, SteadyTime now) const {
    const Eigen::Isometry3f odomInBase = m_base.inverse().cast<float>();
    double oldest = 0.0;
    for (const auto& [topic, laser] : m_lasers) {
        const double age = secondsBetween(laser.came, now);
        if (age > LaserShown) continue;
        oldest = std::max(oldest, age);
        for (const Eigen::Vector3f& point : laser.inOdom)
            view.laser.emplace_back((odomInBase * point).head<2>());
    }
    if (!view.laser.empty()) view.laserAge = oldest;
}

std::optional<VirtualScanView> RobotSight::look(SteadyTime now) const {
    if (!m_newest) return std::nullopt;
    return m_scan.view(m_base, *m_newest + (now - m_arrived));
}

std::optional<SteadyTime> RobotSight::scanned() const {
    const std::lock_guard lock(m_mutex);
    return m_scanned;
}

double RobotSight::spaceAhead() const {
    constexpr double Limit = 2.0, Old = 10.0, Speed = 0.1;  // [m], [s], [m/s]
    const auto around = view();
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    if (!around || !(around->oldest(-0.4, 0.4) < Old)) return unknown;
    return around->freeTravel(Speed, 0.0, m_body, Limit);
}

}  // namespace leitstand
