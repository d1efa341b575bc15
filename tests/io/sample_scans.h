#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/cloud/scan.h"
#include "tests/support/rooms.h"

namespace leitstand::test {

/// An organised scan of a room with everything that files can keep: intensities, labels, no echoes.
inline Scan sampleScan(Sweep sweep, int rows, int columns) {
    RoomScan room = scanRoom({.sweep = sweep, .rows = rows, .columns = columns, .seed = 11});
    Scan scan = room.scan;
    scan.labels = room.trueLabels;
    scan.hasOdometry = false;
    scan.sensorInOdom = Pose::Identity();
    scan.points[3].setConstant(std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        scan.intensities.push_back(0.1F * static_cast<float>(i % 1000));
    }
    return scan;
}

/// The same points in an order that no scanner has, without what files may lack.
inline Scan shuffledScan(Scan scan) {
    scan.rows = scan.columns = 0;
    scan.intensities.clear();
    scan.labels.clear();
    std::vector<Eigen::Vector3f> points;
    const std::size_t stride = 7919;  // a prime: meets every point once
    for (std::size_t i = 0, at = 0; i < scan.points.size(); ++i, at = (at + stride) % scan.points.size()) {
        points.push_back(scan.points[at]);
    }
    scan.points = points;
    return scan;
}

}  // namespace leitstand::test
