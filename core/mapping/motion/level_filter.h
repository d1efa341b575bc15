#pragma once

#include <deque>
#include <optional>

#include <Eigen/Geometry>

#include "core/base/time.h"

namespace leitstand {

/// Tells which way is up on a robot: gyros for how it changes, gravity for where it is in the long run
/// (complementary filter, Mahony, Hamel & Pflimlin 2008). What an inertial unit says of the level at one
/// moment is off by some tenths of a degree, another way two seconds later; within a turn of the scanner that
/// would bend floors. One thread at a time.
class LevelFilter {
public:
    /// What a unit measured at @p stamp, in the robot's frame: the direction upwards, and how the frame turns
    /// [rad/s]. Stamps rise; others are left out, but for a clock that was set: when the next one agrees with
    /// it, the filter begins anew. Without @p turning it is taken as at rest.
    void add(Time stamp, const std::optional<Eigen::Vector3d>& up,
             const std::optional<Eigen::Vector3d>& turning);
    /// The direction upwards at @p stamp, unit length; empty where nothing was measured within @p gap.
    [[nodiscard]] std::optional<Eigen::Vector3d> at(
        Time stamp, std::chrono::nanoseconds gap = std::chrono::milliseconds(300)) const;
    void forgetBefore(Time stamp);
    void clear() { m_entries.clear(), m_stray.reset(), m_settled = {}; }
    /// Stamp of the newest measurement that counts; empty: none.
    [[nodiscard]] std::optional<Time> newest() const {
        return m_entries.empty() ? std::nullopt : std::optional(m_entries.back().stamp);
    }

private:
    struct Entry {
        Time stamp;
        Eigen::Vector3d up;
        Eigen::Vector3d turning;
    };
    void begin(const Entry& entry);

    std::deque<Entry> m_entries;
    std::optional<Entry> m_stray;  ///< its stamp does not fit the others: a jump, if the next one fits it
    std::chrono::nanoseconds m_settled{};  ///< for how long the filter has run
};

}  // namespace leitstand
