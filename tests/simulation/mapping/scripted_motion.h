#pragma once

#include <cstdint>
#include <vector>

#include "core/event/motion_samples.h"
#include "tests/simulation/mapping/scripted_drive.h"

namespace leitstand::simulation::test {

inline constexpr Time ScriptBegin{std::chrono::seconds(1'000)};

/// How a robot goes along a path: it stands, gains speed, and goes on evenly.
class ScriptedMotion {
public:
    ScriptedMotion(const DrivePath& path, const ScriptSettings& settings);

    [[nodiscard]] double way(double seconds) const;  ///< [m]
    [[nodiscard]] Pose baseAt(double seconds) const { return m_path.at(way(seconds)); }
    [[nodiscard]] Pose baseAt(Time stamp) const;
    [[nodiscard]] double duration() const { return m_duration; }  ///< [s]
    [[nodiscard]] double length() const { return m_length; }      ///< [m]

private:
    const DrivePath& m_path;
    double m_speed, m_length, m_duration = 0.0;
};

/// What odometry and the inertial unit say on the way, 20 times a second.
struct MotionSamples {
    std::vector<OdometrySample> odometry;
    std::vector<ImuSample> imu;  ///< as many, at the same moments
};
[[nodiscard]] MotionSamples motionSamples(const ScriptedMotion& motion, const OdometryErrors& errors,
                                          std::uint64_t seed);

}  // namespace leitstand::simulation::test
