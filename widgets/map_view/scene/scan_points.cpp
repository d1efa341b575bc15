#include "widgets/map_view/scene/scan_points.h"

#include <algorithm>
#include <cstdint>
#include <random>

namespace leitstand {

ScanPoints drawablePoints(const Scan& scan, double minRange, double maxRange) {
    const auto lowest = static_cast<float>(minRange * minRange);
    const auto highest = static_cast<float>(maxRange * maxRange);
    std::vector<std::uint32_t> order;
    order.reserve(scan.points.size());
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const float range = scan.points[i].squaredNorm();  // NaN passes neither comparison
        if (range >= lowest && range <= highest) order.push_back(static_cast<std::uint32_t>(i));
    }
    std::shuffle(order.begin(), order.end(), std::minstd_rand(1));

    ScanPoints result;
    result.points.reserve(order.size());
    result.labels.reserve(order.size());
    const bool labelled = scan.labels.size() == scan.points.size();
    for (const std::uint32_t i : order) {
        result.points.push_back(scan.points[i]);
        result.labels.push_back(labelled ? scan.labels[i] : Label::Unlabelled);
        ++result.labelCounts[static_cast<std::size_t>(result.labels.back())];
        result.bounds.extend(scan.points[i]);
    }
    return result;
}

}  // namespace leitstand
