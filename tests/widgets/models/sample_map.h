#pragma once

#include <memory>
#include <string>

#include "core/mapping/map.h"

namespace leitstand::test {

/// A registered scan with plausible figures, or the first of a map.
inline MapScan sampleScan(const std::string& name, bool registered) {
    auto scan = std::make_shared<Scan>();
    scan->name = name;
    scan->points.resize(81'360, Eigen::Vector3f(1, 0, 0));
    MapScan placed;
    placed.scan = scan;
    placed.pointsUsed = 9'544;
    placed.labelCounts = {360, 20'000, 50'000, 10'000};
    placed.registered = registered;
    placed.seconds = 0.2;
    if (!registered) return placed;
    placed.guessInMap = poseFrom({1.5, 0, 0}, 0, 0, 0);
    placed.poseInMap = poseFrom({1.57, 0.04, -0.09}, 0, 0, degrees(-0.7));
    placed.icp.converged = true;
    placed.icp.stop = IcpStop::Converged;
    placed.icp.iterations = 12;
    placed.icp.rms = 0.0123;
    placed.icp.overlap = 0.834;
    placed.icp.certainty = 0.19;
    return placed;
}

/// A map of @p count sample scans, the first of them the reference.
inline std::shared_ptr<Map> sampleMap(int count) {
    auto map = std::make_shared<Map>();
    for (int i = 0; i < count; ++i) map->scans.push_back(sampleScan("scan00" + std::to_string(i), i > 0));
    return map;
}

}  // namespace leitstand::test
