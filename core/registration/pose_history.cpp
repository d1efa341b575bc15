#include "core/registration/pose_history.h"

#include <algorithm>
#include <cassert>

namespace leitstand {
namespace {

constexpr std::size_t LongestPeriod = 20;
constexpr std::size_t WanderLength = 40;  // poses checked for wandering

}  // namespace

void PoseHistory::add(const Pose& pose, double cost) {
    m_entries.push_back({pose, cost});
}

std::size_t PoseHistory::cycle(double tolerance) const {
    for (std::size_t period = 2; period <= LongestPeriod; ++period) {
        if (repeats(period, tolerance)) return period;
    }
    return wanders() ? WanderLength : 0;
}

bool PoseHistory::repeats(std::size_t period, double tolerance) const {
    const std::size_t count = m_entries.size();
    if (count < 2 * period + 1) return false;
    for (std::size_t i = 0; i <= period; ++i) {
        const Pose& now = m_entries[count - 1 - i].pose;
        const Pose& before = m_entries[count - 1 - i - period].pose;
        if (distanceBetween(now, before) > tolerance || angleBetween(now, before) > tolerance) return false;
    }
    return true;
}

bool PoseHistory::wanders() const {
    const std::size_t count = m_entries.size();
    if (count < WanderLength) return false;
    const Extent size = extent(WanderLength);
    if (size.distance > CycleDistance || size.angle > CycleAngle) return false;
    // Steps that do not get shorter: compares the last 20 with the 20 before.
    const auto travelled = [&](std::size_t last) {
        double sum = 0.0;
        for (std::size_t i = last - WanderLength / 2 + 1; i < last; ++i) {
            sum += distanceBetween(m_entries[i].pose, m_entries[i - 1].pose);
        }
        return sum;
    };
    return travelled(count) > 0.9 * travelled(count - WanderLength / 2);
}

const Pose& PoseHistory::best(std::size_t count) const {
    assert(count > 0 && count <= m_entries.size());
    return std::min_element(m_entries.end() - static_cast<std::ptrdiff_t>(count), m_entries.end(),
                            [](const Entry& a, const Entry& b) { return a.cost < b.cost; })
        ->pose;
}

PoseHistory::Extent PoseHistory::extent(std::size_t count) const {
    const Pose& centre = best(count);
    Extent size;
    for (auto entry = m_entries.end() - static_cast<std::ptrdiff_t>(count); entry != m_entries.end();
         ++entry) {
        size.distance = std::max(size.distance, distanceBetween(entry->pose, centre));
        size.angle = std::max(size.angle, angleBetween(entry->pose, centre));
    }
    return size;
}

}  // namespace leitstand
