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

/// The source of a pose of MotionBuffer.
enum class MotionSource : std::uint8_t {
    Measured,      ///< between two poses of the odometry
    Bridged,       ///< between two poses that are far apart in time: at most the turn in between is known
    Extrapolated,  ///< beyond the newest pose: by its last velocity and the gyros; also the nearest pose,
                   ///< before the oldest one or where odometry restarted
};

/// Returns whether @p a and @p b, in the odometry's frame, are so far apart that no robot moves so far in
/// @p time [s]. Then the odometry restarted.
[[nodiscard]] bool leaps(const Pose& a, const Pose& b, double time);

/// The pose of a robot at a moment.
struct Motion {
    Pose baseInOdom = Pose::Identity();  ///< level by the inertial unit if there is one
    MotionSource source = MotionSource::Measured;
};

/// How far a robot drove and turned; forward and back both count.
struct Travel {
    double way = 0.0;   ///< [m]
    double turn = 0.0;  ///< of its heading [rad]
};

/// How a robot moved in the last minutes: position and heading by its odometry, level by gyros and gravity.
/// The gyros measure the heading where odometry is missing. Stamps are the robot's clock, which may jump, and
/// the odometry may restart. One thread at a time.
class MotionBuffer {
public:
    static constexpr std::chrono::seconds Memory{150};
    static constexpr std::chrono::milliseconds LongestStep{500};  ///< between poses, to count as measured
    static constexpr std::chrono::seconds LongestBridge{20};
    static constexpr std::chrono::milliseconds LongestGuess{500};  ///< beyond the newest pose

    void add(const OdometrySample& odometry);
    /// @p unitInBase: mount of the inertial unit.
    void add(const ImuSample& imu, const Pose& unitInBase);

    /// Returns where the robot was at @p stamp; empty where that is unknown.
    [[nodiscard]] std::optional<Motion> at(Time stamp) const;
    /// Returns whether odometry of @p stamp or later was received.
    [[nodiscard]] bool covers(Time stamp) const;
    /// Returns how far the odometry went between the two stamps, without the steps where it restarted.
    [[nodiscard]] Travel travelled(Time from, Time to) const;
    /// Returns the up direction in base_link, by the inertial unit; empty without one.
    [[nodiscard]] std::optional<Eigen::Vector3d> up(Time stamp) const { return m_level.at(stamp); }
    /// Returns whether an inertial unit ever measured the up direction. Then the odometry's level is no
    /// substitute, since odometry may know no slopes.
    [[nodiscard]] bool hasUnit() const { return m_hasUnit; }
    /// Returns a number that rises when the robot's clock jumps back: earlier samples are of another time.
    [[nodiscard]] int clockJumps() const { return m_clockJumps; }
    /// Returns the number of the odometry at @p stamp. The number rises when the odometry restarts, since its
    /// frame is another one then.
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
    /// Returns @p pose, interpolated from @p before to @p after at @p stamp, with its heading by the gyros.
    [[nodiscard]] Pose turnedByGyro(const Pose& pose, const Entry& before, const Entry& after,
                                    Time stamp) const;

    std::deque<Entry> m_entries;   ///< by stamp
    std::optional<Entry> m_stray;  ///< its stamp does not fit; if the next one agrees, the clock was set
    LevelFilter m_level;
    TurnGyro m_gyro;
    bool m_hasUnit = false;
    int m_clockJumps = 0;
    int m_frame = 0;
};

}  // namespace leitstand
