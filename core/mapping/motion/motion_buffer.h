#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/motion/level_filter.h"
#include "core/mapping/motion/turn_gyro.h"

namespace leitstand {

struct ImuSample;
struct OdometrySample;

/// How MotionBuffer knows a pose.
enum class MotionSource : std::uint8_t {
    Measured,  ///< interpolated between two poses of the odometry
    /// Interpolated between two poses that are far apart in time; only the turn between them may be known.
    Bridged,
    /// After the newest pose: extrapolated from its last velocity and the gyros. Before the oldest pose, or
    /// where odometry restarted: the nearest pose.
    Extrapolated,
};

/// Returns whether no robot can move from @p a to @p b (odometry's frame) within @p time [s]. If so, the
/// odometry restarted.
[[nodiscard]] bool leaps(const Pose& a, const Pose& b, double time);

/// The pose of a robot at one time.
struct Motion {
    Pose baseInOdom = Pose::Identity();  ///< levelled by the inertial unit if there is one
    MotionSource source = MotionSource::Measured;
};

/// How far a robot drove and turned. Forward and backward both add to it.
struct Travel {
    double way = 0.0;   ///< distance [m]
    double turn = 0.0;  ///< change of heading, all turns added up [rad]
};

/// How a robot moved in the last minutes: position and heading from its odometry, level from gyros and
/// gravity. Where odometry is missing, the gyros measure the heading. Stamps are the robot's clock, which may
/// jump, and the odometry may restart. One thread at a time.
class MotionBuffer {
public:
    static constexpr std::chrono::seconds Memory{150};
    /// Longest time between two poses for which a pose between them counts as measured.
    static constexpr std::chrono::milliseconds LongestStep{500};
    static constexpr std::chrono::seconds LongestBridge{20};
    /// Longest extrapolation after the newest pose.
    static constexpr std::chrono::milliseconds LongestGuess{500};

    void add(const OdometrySample& odometry);
    /// @p unitInBase: mount of the inertial unit.
    void add(const ImuSample& imu, const Pose& unitInBase);

    /// Returns where the robot was at @p stamp; empty: unknown.
    [[nodiscard]] std::optional<Motion> at(Time stamp) const;
    /// Returns whether odometry of @p stamp or later was received.
    [[nodiscard]] bool covers(Time stamp) const;
    /// Returns how far the robot travelled between the two stamps, by its odometry. Jumps where it restarted
    /// are not included.
    [[nodiscard]] Travel travelled(Time from, Time to) const;
    /// Returns the up direction in base_link from the inertial unit; empty without a unit.
    [[nodiscard]] std::optional<Eigen::Vector3d> up(Time stamp) const { return m_level.at(stamp); }
    /// Returns whether an inertial unit has ever measured the up direction. If so, odometry's level must not
    /// replace it, since odometry may not measure slopes.
    [[nodiscard]] bool hasUnit() const { return m_hasUnit; }
    /// Returns a number that rises when the robot's clock jumps back. Earlier samples then have stamps of
    /// another clock.
    [[nodiscard]] int clockJumps() const { return m_clockJumps; }
    /// Returns the number of the odometry at @p stamp. It rises when the odometry restarts, because its frame
    /// changes then.
    [[nodiscard]] int frameAt(Time stamp) const;

private:
    struct Entry {
        Time stamp;
        Pose baseInOdom;
        int frame;
    };
    void keep(Time stamp, const Pose& baseInOdom);
    [[nodiscard]] Pose levelled(Pose baseInOdom, Time stamp) const;
    [[nodiscard]] std::deque<Entry>::const_iterator after(Time stamp) const;
    [[nodiscard]] std::optional<Motion> beyond(Time stamp) const;
    /// Returns @p pose, which is interpolated from @p before to @p after at @p stamp, with the heading
    /// measured by the gyros.
    [[nodiscard]] Pose turnedByGyro(const Pose& pose, const Entry& before, const Entry& after,
                                    Time stamp) const;

    std::deque<Entry> m_entries;  ///< by stamp
    /// Sample whose stamp does not fit; if the next one agrees, the clock was set.
    std::optional<Entry> m_stray;
    LevelFilter m_level;
    TurnGyro m_gyro;
    bool m_hasUnit = false;
    int m_clockJumps = 0;
    int m_frame = 0;
};

}  // namespace leitstand
