#include "app/services/coverage/searched_scans.h"

#include "core/event/map_samples.h"

namespace leitstand {

ReportScan scanOf(const KeyScanSample& sample) {
    return {.id = sample.id,
            .scan = sample.scan,
            .scanInMap = sample.scanInMap,
            .sensorInBase = sample.sensorInBase};
}

std::vector<Eigen::Vector3d> trailsOf(const RobotsInMap& robots) {
    std::vector<Eigen::Vector3d> trails;
    for (const RobotInMap& one : robots) {
        if (!one.placed) continue;
        for (const TrailPlace& step : *one.trail) trails.push_back(step.inMap.cast<double>());
        trails.emplace_back(one.baseInMap.translation());
    }
    return trails;
}

}  // namespace leitstand
