#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/motion_samples.h"
#include "core/mapping/motion/level_filter.h"
#include "core/mapping/motion/turn_gyro.h"

namespace leitstand {

/// How a pose of MotionBuffer came about.
enum class MotionSource : std::uint8_t {
    Measured,      ///< between two poses of the odometry
    Bridged,       ///< between two that are far apart: nobody knows the way between, at most how it turned
    Extrapolated,  ///< beyond the newest, as it moved last, and turned as its gyros say
};

/// Whether no robot moves from @p a to @p b, in its odometry's frame, in @p time [s]: that began anew.
[[nodiscard]] bool leaps(const Pose& a, const Pose& b, double time);

/// Where a robot was.
struct Motion {
    Pose baseInOdom = Pose::Identity();  ///< level by the inertial unit where there is one
    MotionSource source = MotionSource::Measured;
};

/// How far a robot went, to and fro.
struct Travel {
    double way = 0.0;   ///< [m]
    double turn = 0.0;  ///< of its heading [rad]
};

/// How a robot moved in the last minutes: position and heading by its odometry, level by gyros and gravity;
/// heading by the gyros where odometry is missing.
/// Stamps are the robot's clock, which may jump, and the odometry may begin anew. One thread at a time.
class MotionBuffer {
public:
    static constexpr std::chrono::seconds Memory{150};
    static constexpr std::chrono::milliseconds LongestStep{500};  ///< between poses, to count as measured
    static constexpr std::chrono::seconds LongestBridge{20};
    static constexpr std::chrono::milliseconds LongestGuess{500};  ///< beyond the newest pose

    void add(const OdometrySample& odometry);
    /// @p unitInBase: how the inertial unit sits.
    void add(const ImuSample& imu, const Pose& unitInBase);

    /// Where the robot was at @p stamp; empty where that cannot be told.
    [[nodiscard]] std::optional<Motion> at(Time stamp) const;
    /// Whether odometry of @p stamp or later came.
    [[nodiscard]] bool covers(Time stamp) const;
    /// What the odometry went between the two stamps; nothing where it began anew.
    [[nodiscard]] Travel travelled(Time from, Time to) const;
    /// The direction upwards in base_link, by the inertial unit; empty without one.
    [[nodiscard]] std::optional<Eigen::Vector3d> up(Time stamp) const { return m_level.at(stamp); }
    /// Whether a unit ever told it: then the odometry's level is no substitute, it may know no slopes.
    [[nodiscard]] bool hasUnit() const { return m_hasUnit; }
    /// Rises when the robot's clock jumped back: what was told before is of another time.
    [[nodiscard]] int clockJumps() const { return m_clockJumps; }
    /// The number of the odometry at @p stamp: rises when it began anew, so that its frame is another one.
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
    /// @p pose, which lies between the two on a straight way, with the heading that the gyros tell.
    [[nodiscard]] Pose turnedByGyro(const Pose& pose, const Entry& before, const Entry& after,
                                    Time stamp) const;

    std::deque<Entry> m_entries;   ///< by stamp
    std::optional<Entry> m_stray;  ///< its stamp does not fit the others: a jump, if the next one fits it
    LevelFilter m_level;
    TurnGyro m_gyro;
    bool m_hasUnit = false;
    int m_clockJumps = 0;
    int m_frame = 0;
};

}  // namespace leitstand
