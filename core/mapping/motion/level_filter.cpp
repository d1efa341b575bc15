#include "core/mapping/motion/level_filter.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {
namespace {

constexpr double Slow = 6.0;             ///< time constant of gravity while it agrees [s]
constexpr double Fast = 0.25;            ///< ... and when it disagrees wholly: a gyro missed something [s]
constexpr double Agrees = degrees(0.6);  ///< up to this difference [rad]
constexpr double Disagrees = degrees(2.0);
constexpr std::chrono::seconds LongestStep(1);          ///< between measurements; beyond, the filter restarts
constexpr std::chrono::milliseconds BackwardStep(500);  ///< stamps that go back farther are a clock jump
constexpr std::chrono::seconds ForwardStep(5);          ///< stamps that go ahead farther are doubted at first
constexpr std::chrono::seconds StrayFits(1);            ///< a doubted one is right if the next one is so near

/// Returns the fixed direction @p up in a frame that turned by @p turning [rad].
Eigen::Vector3d carried(const Eigen::Vector3d& up, const Eigen::Vector3d& turning) {
    const double angle = turning.norm();
    if (!(angle > 0.0)) return up;
    return Eigen::AngleAxisd(-angle, turning / angle) * up;
}

}  // namespace

void LevelFilter::begin(const Entry& entry) {
    m_entries.push_back(entry);
    m_settled = {};
}

void LevelFilter::add(Time stamp, const std::optional<Eigen::Vector3d>& up,
                      const std::optional<Eigen::Vector3d>& turning) {
    if ((up && !(up->allFinite() && up->norm() > 0.0)) || (turning && !turning->allFinite())) return;
    const Eigen::Vector3d rate = turning.value_or(Eigen::Vector3d::Zero());
    const std::optional<Entry> here = up ? std::optional(Entry{stamp, up->normalized(), rate}) : std::nullopt;
    if (!m_entries.empty()) {
        const auto ahead = stamp - m_entries.back().stamp;
        if (ahead < -BackwardStep || ahead > ForwardStep) {
            const bool confirmed = m_stray && stamp > m_stray->stamp && stamp - m_stray->stamp <= StrayFits;
            if (!confirmed) {
                if (here) m_stray = here;
                return;
            }
            if (ahead < -BackwardStep) m_entries.clear();
            begin(*m_stray);
        }
        m_stray.reset();
    }
    if (m_entries.empty() || stamp - m_entries.back().stamp > LongestStep) {
        if (here) begin(*here);
        return;
    }
    const Entry& last = m_entries.back();
    if (stamp <= last.stamp) return;
    const double step = toSeconds(stamp - last.stamp);
    m_settled += stamp - last.stamp;
    Eigen::Vector3d now = carried(last.up, 0.5 * step * (last.turning + rate));
    if (up) {
        const Eigen::Vector3d measured = up->normalized();
        const double off = std::atan2(now.cross(measured).norm(), now.dot(measured));
        const double doubt = std::clamp((off - Agrees) / (Disagrees - Agrees), 0.0, 1.0);
        // At first the mean of the measurements so far.
        const double patience = std::min(Slow, std::max(toSeconds(m_settled), step));
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
        return carried(last.up, toSeconds(stamp - last.stamp) * last.turning);
    }
    if (after == m_entries.begin()) {
        return after->stamp - stamp <= gap ? std::optional(after->up) : std::nullopt;
    }
    const Entry& before = *std::prev(after);
    if (after->stamp - before.stamp > 2 * gap) return std::nullopt;
    const double share = toSeconds(stamp - before.stamp) / toSeconds(after->stamp - before.stamp);
    return ((1.0 - share) * before.up + share * after->up).normalized();
}

void LevelFilter::forgetBefore(Time stamp) {
    while (m_entries.size() > 2 && m_entries.front().stamp < stamp) m_entries.pop_front();
}

}  // namespace leitstand
