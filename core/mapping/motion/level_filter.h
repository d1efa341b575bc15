#pragma once

#include <deque>
#include <optional>

#include <Eigen/Geometry>

#include "core/base/time.h"

namespace leitstand {

/// Estimates the up direction of a robot. Gyros measure how it changes, gravity measures its long-term mean
/// (complementary filter, Mahony, Hamel & Pflimlin 2008). The level that an inertial unit reports has an
/// error of some tenths of a degree, which changes within seconds. During a turn of the scanner, this error
/// would bend floors. One thread at a time.
class LevelFilter {
public:
    /// Adds a measurement of the inertial unit at @p stamp, in the robot's frame: the up direction and the
    /// angular velocity @p turning [rad/s]. Stamps must rise; other measurements are ignored. But if a
    /// measurement with such a stamp agrees with the next one, the clock was set, and the filter restarts.
    /// Without @p turning, the robot is assumed not to turn.
    void add(Time stamp, const std::optional<Eigen::Vector3d>& up,
             const std::optional<Eigen::Vector3d>& turning);
    /// Returns the up direction at @p stamp (unit length). Empty: there is no measurement within @p gap.
    [[nodiscard]] std::optional<Eigen::Vector3d> at(
        Time stamp, std::chrono::nanoseconds gap = std::chrono::milliseconds(300)) const;
    void forgetBefore(Time stamp);
    void clear() { m_entries.clear(), m_stray.reset(), m_settled = {}; }
    /// Stamp of the newest measurement that was used; empty: none.
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
    /// Measurement whose stamp does not fit; if the next one agrees, the clock was set.
    std::optional<Entry> m_stray;
    std::chrono::nanoseconds m_settled{};  ///< run time of the filter
};

}  // namespace leitstand
