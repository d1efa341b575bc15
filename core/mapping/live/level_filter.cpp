#include "core/mapping/live/level_filter.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/pose.h"

namespace leitstand {
namespace {

constexpr double Slow = 6.0;             ///< time constant of gravity's say, while it agrees [s]
constexpr double Fast = 0.25;            ///< ... and when it disagrees wholly: a gyro missed something [s]
constexpr double Agrees = degrees(0.6);  ///< up to here
constexpr double Disagrees = degrees(2.0);
constexpr std::chrono::seconds LongestStep(1);  ///< between measurements; beyond, the filter begins anew

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

/// A fixed direction in a frame that turned by @p turning.
Eigen::Vector3d carried(const Eigen::Vector3d& up, const Eigen::Vector3d& turning) {
    const double angle = turning.norm();
    if (!(angle > 0.0)) return up;
    return Eigen::AngleAxisd(-angle, turning / angle) * up;
}

}  // namespace

void LevelFilter::add(Time stamp, const std::optional<Eigen::Vector3d>& up,
                      const std::optional<Eigen::Vector3d>& turning) {
    if ((up && !(up->allFinite() && up->norm() > 0.0)) || (turning && !turning->allFinite())) return;
    const Eigen::Vector3d rate = turning.value_or(Eigen::Vector3d::Zero());
    if (m_entries.empty() || stamp - m_entries.back().stamp > LongestStep) {
        if (!up) return;
        m_entries.push_back({stamp, up->normalized(), rate});
        m_settled = {};
        return;
    }
    const Entry& last = m_entries.back();
    if (stamp <= last.stamp) return;
    const double step = seconds(stamp - last.stamp);
    m_settled += stamp - last.stamp;
    Eigen::Vector3d now = carried(last.up, 0.5 * step * (last.turning + rate));
    if (up) {
        const Eigen::Vector3d measured = up->normalized();
        const double off = std::atan2(now.cross(measured).norm(), now.dot(measured));
        const double doubt = std::clamp((off - Agrees) / (Disagrees - Agrees), 0.0, 1.0);
        // At first the mean of what was measured so far.
        const double patience = std::min(Slow, std::max(seconds(m_settled), step));
        const double constant = patience * std::pow(std::min(1.0, Fast / patience), doubt);
        now = (now + (1.0 - std::exp(-step / constant)) * (measured - now)).normalized();
    }
    m_entries.push_back({stamp, now, rate});
}

std::optional<Eigen::Vector3d> LevelFilter::at(Time stamp, std::chrono::nanoseconds gap) const {
    const auto after = std::lower_bound(m_entries.begin(), m_entries.end(), stamp,
                                        [](const Entry& entry, Time wanted) { return entry.stamp < wanted; });
    if (after == m_entries.end()) {
        if (m_entries.empty() || stamp - m_entries.back().stamp > gap) return std::nullopt;
        const Entry& last = m_entries.back();
        return carried(last.up, seconds(stamp - last.stamp) * last.turning);
    }
    if (after == m_entries.begin()) {
        return after->stamp - stamp <= gap ? std::optional(after->up) : std::nullopt;
    }
    const Entry& before = *std::prev(after);
    if (after->stamp - before.stamp > 2 * gap) return std::nullopt;
    const double share = seconds(stamp - before.stamp) / seconds(after->stamp - before.stamp);
    return ((1.0 - share) * before.up + share * after->up).normalized();
}

void LevelFilter::forgetBefore(Time stamp) {
    while (m_entries.size() > 2 && m_entries.front().stamp < stamp) m_entries.pop_front();
}

}  // namespace leitstand
