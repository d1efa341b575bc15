#include "widgets/map_view/scene/scene_sample.h"

#include <algorithm>
#include <memory>

namespace leitstand {
namespace {

constexpr std::size_t AtATime = 8;  ///< points taken from a scan before the next scan

}  // namespace

SceneSample sampleOf(const std::vector<SceneScan>& scans, std::size_t most,
                     const std::vector<SceneScan>& ghosts) {
    struct Taken {
        const SceneScan* scan;
        ShownPoints points;
        std::size_t count;  ///< points still to be taken
    };
    std::vector<Taken> shown;
    std::size_t all = 0;
    for (const std::vector<SceneScan>* some : {&scans, &ghosts}) {
        for (const SceneScan& scan : *some) {
            if (!isShown(scan)) continue;
            shown.push_back({&scan, ShownPoints(scan), scan.look->shown});
            all += scan.look->shown;
        }
    }
    SceneSample sample;
    if (all > most) sample.share = static_cast<double>(most) / static_cast<double>(all);
    for (Taken& one : shown)
        one.count = static_cast<std::size_t>(sample.share * static_cast<double>(one.count));
    const auto drawn = std::make_shared<DrawnPoints>();
    drawn->points.reserve(std::min(all, most));
    drawn->colours.reserve(std::min(all, most));
    for (bool more = !shown.empty(); more;) {
        more = false;
        for (Taken& one : shown) {
            const std::size_t now = std::min(one.count, AtATime);
            one.points.append(now, one.scan->poseInMap, *drawn);
            one.count -= now;
            more = more || one.count > 0;
        }
    }
    sample.points = drawn;
    return sample;
}

}  // namespace leitstand
