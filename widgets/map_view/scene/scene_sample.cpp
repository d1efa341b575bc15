#include "widgets/map_view/scene/scene_sample.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>

#include "core/scan/scan.h"

namespace leitstand {
namespace {

constexpr std::size_t AtATime = 8;  ///< points of a scan before the next scan's come

bool isShown(const SceneScan& scan) {
    return scan.visible && scan.points && scan.look.colours && scan.look.shown && !scan.look.shown->empty();
}

}  // namespace

SceneSample sampleOf(const std::vector<SceneScan>& scans, std::size_t most) {
    std::vector<const SceneScan*> shown;
    std::size_t all = 0;
    for (const SceneScan& scan : scans) {
        if (!isShown(scan)) continue;
        shown.push_back(&scan);
        all += scan.look.shown->size();
    }
    SceneSample sample;
    if (all > most) sample.share = static_cast<double>(most) / static_cast<double>(all);
    const auto taken = [&sample](const SceneScan& scan) {
        return static_cast<std::size_t>(sample.share * static_cast<double>(scan.look.shown->size()));
    };
    const auto merged = std::make_shared<Scan>();
    const auto colours = std::make_shared<std::vector<Rgba>>();
    merged->points.reserve(std::min(all, most));
    colours->reserve(std::min(all, most));
    bool more = !shown.empty();
    for (std::size_t first = 0; more; first += AtATime) {
        more = false;
        for (const SceneScan* scan : shown) {
            const std::size_t end = taken(*scan);
            const Eigen::Affine3f inMap(scan->poseInMap.cast<float>());
            for (std::size_t i = first; i < std::min(end, first + AtATime); ++i) {
                const std::size_t index = (*scan->look.shown)[i];
                merged->points.push_back(inMap * scan->points->points[index]);
                colours->push_back((*scan->look.colours)[index]);
            }
            more = more || end > first + AtATime;
        }
    }
    std::vector<std::uint32_t> order(merged->points.size());
    std::iota(order.begin(), order.end(), 0U);
    auto points = std::make_shared<ScanPoints>();
    points->points = merged->points;
    points->owner = merged;
    sample.scan.points = std::move(points);
    sample.scan.look = {colours, std::make_shared<const PointOrder>(order)};
    return sample;
}

}  // namespace leitstand
