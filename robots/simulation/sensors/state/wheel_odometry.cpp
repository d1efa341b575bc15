#include "robots/simulation/sensors/state/wheel_odometry.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/time.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {
namespace {

constexpr double StandingStep = 1e-7;          ///< a wheel that moves less in a step stands still [m]
constexpr double DistanceError = 0.05;         ///< share of the way that slip may take
constexpr double HeadingError = degrees(0.5);  ///< for each metre [rad]

}  // namespace

void DeadReckoning::step(double left, double right, const MeasuredAttitude& attitude) {
    const double turned = std::remainder(attitude.heading - m_lastHeading, 2.0 * std::numbers::pi);
    m_lastHeading = attitude.heading;
    const bool standing = std::abs(left) < StandingStep && std::abs(right) < StandingStep;
    const double halfway = m_heading + (standing ? 0.0 : turned / 2.0);
    if (!standing) m_heading = std::remainder(m_heading + turned, 2.0 * std::numbers::pi);
    const double forward = (left + right) / 2.0;
    const Eigen::Vector3d along =
        poseFrom(Eigen::Vector3d::Zero(), attitude.roll, attitude.pitch, halfway).linear().col(0);
    m_distance += (std::abs(left) + std::abs(right)) / 2.0;
    m_pose = poseFrom(m_pose.translation() + forward * along, attitude.roll, attitude.pitch, m_heading);
}

WheelOdometry::WheelOdometry(const OdometrySettings& settings, const InertialUnit& unit, Time start)
    : m_settings(settings), m_unit(unit), m_schedule(settings.rate, start) {}

OdometrySample WheelOdometry::sampleOf(const MeasuredAttitude& attitude, const BodyState& state) const {
    OdometrySample sample;
    sample.header = {attitude.stamp, m_settings.odomFrame};
    sample.childFrame = m_settings.baseFrame;
    sample.baseInOdom = m_reckoning.pose();
    sample.linear.x() = (state.left + state.right) / 2.0;
    const bool standing = state.left == 0.0 && state.right == 0.0;
    if (!standing) sample.angular = attitude.angular;
    const double along = 0.01 + DistanceError * m_reckoning.distance();
    const double turn = degrees(0.5) + HeadingError * m_reckoning.distance();
    for (std::size_t i = 0; i < 6; ++i) {
        sample.poseCovariance[7 * i] = i < 3 ? along * along : turn * turn;
        sample.twistCovariance[7 * i] = i < 3 ? 4e-4 : 1e-4;
    }
    return sample;
}

void WheelOdometry::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    const BodyState& state = world.state(robot);
    const Encoders now{world.now(), state.travelledLeft, state.travelledRight};
    if (!m_begun) m_before = m_reported = now;
    m_begun = true;
    const double seconds = toSeconds(now.at - m_before.at);
    for (const MeasuredAttitude& attitude : m_unit.attitudes()) {
        const double after = toSeconds(attitude.stamp - m_before.at);
        const double share = seconds > 0.0 ? std::clamp(after / seconds, 0.0, 1.0) : 1.0;
        const Encoders here{attitude.stamp, std::lerp(m_before.left, now.left, share),
                            std::lerp(m_before.right, now.right, share)};
        m_reckoning.step(here.left - m_reported.left, here.right - m_reported.right, attitude);
        m_reported = here;
        while (m_schedule.due(attitude.stamp)) {
            OdometrySample odometry = sampleOf(attitude, state);
            if (m_transformsEnabled) {
                samples.push_back(
                    {StreamRole::Transforms,
                     {},
                     TransformsSample{{{odometry.header, odometry.childFrame, odometry.baseInOdom}}}});
            }
            if (m_odometryEnabled) samples.push_back({StreamRole::Odometry, {}, std::move(odometry)});
        }
    }
    m_before = now;
}

bool WheelOdometry::configure(StreamRole role, const std::string&, const StreamSettings& settings) {
    if (role == StreamRole::Transforms) {
        m_transformsEnabled = settings.enabled;
        return false;  // joints have transforms too
    }
    if (role != StreamRole::Odometry) return false;
    m_odometryEnabled = settings.enabled;
    m_schedule.setRate(settings.rate > 0.0 ? std::min(settings.rate, m_settings.mostRate) : m_settings.rate);
    return true;
}

}  // namespace leitstand::simulation
