#include "core/mapping/live/map/kept_scan.h"

#include <memory>
#include <utility>

#include "core/mapping/live/scan_work.h"

namespace leitstand {
namespace {

/// Merges the values for each point of two scans. @p which: places of the points of @p out in the whole.
template <typename T>
std::vector<T> merged(const std::vector<T>& rest, const std::vector<T>& out,
                      const std::vector<std::uint32_t>& which) {
    std::vector<T> all;
    all.reserve(rest.size() + out.size());
    auto next = rest.begin();
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto until = next + static_cast<std::ptrdiff_t>(which[i] - all.size());
        all.insert(all.end(), next, until);
        next = until;
        all.push_back(out[i]);
    }
    all.insert(all.end(), next, rest.end());
    return all;
}

}  // namespace

ScanPtr KeptScan::joined() const {
    if (m_which.empty()) return m_inside;
    auto whole = std::make_shared<Scan>(selected(*m_inside, {}));
    whole->rows = m_rows;
    whole->columns = m_columns;
    whole->points = merged(m_inside->points, m_leftOut.points, m_which);
    whole->intensities = merged(m_inside->intensities, m_leftOut.intensities, m_which);
    whole->labels = merged(m_inside->labels, m_leftOut.labels, m_which);
    whole->shades = merged(m_inside->shades, m_leftOut.shades, m_which);
    return whole;
}

ScanPtr KeptScan::whole() const {
    const std::lock_guard lock(m_mutex);
    return joined();
}

ScanPtr KeptScan::inside() const {
    const std::lock_guard lock(m_mutex);
    return m_inside;
}

std::size_t KeptScan::leftOut() const {
    const std::lock_guard lock(m_mutex);
    return m_which.size();
}

void KeptScan::putAllBack() {
    const std::lock_guard lock(m_mutex);
    m_inside = joined();
    m_leftOut = {};
    m_which = {};
}

void KeptScan::leaveOutAllBut(const std::vector<std::size_t>& kept, const ScanPtr& whole) {
    const std::lock_guard lock(m_mutex);
    m_inside = whole;
    m_leftOut = {};
    m_which = {};
    if (kept.size() == whole->points.size()) return;
    std::vector<std::size_t> missing;
    missing.reserve(whole->points.size() - kept.size());
    for (std::size_t i = 0, next = 0; i < whole->points.size(); ++i) {
        if (next < kept.size() && kept[next] == i) {
            ++next;
        } else {
            missing.push_back(i);
        }
    }
    m_which.assign(missing.begin(), missing.end());
    m_rows = whole->rows;
    m_columns = whole->columns;
    m_leftOut = selected(*whole, missing);
    m_inside = std::make_shared<const Scan>(selected(*whole, kept));
}

}  // namespace leitstand
