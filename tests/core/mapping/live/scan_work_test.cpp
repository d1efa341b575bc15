#include "core/mapping/live/scan_work.h"

#include <gtest/gtest.h>

namespace leitstand {
namespace {

TEST(ScanWork, AScanThatSeesLittleIsMatchedMoreFinelyAlsoWhenItIsTriedAgain) {
    // A piece of wall of 1.2 m x 1.2 m, 1 m ahead: some 120 voxels of 12 cm.
    const auto scan = std::make_shared<Scan>();
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 60; ++column)
            scan->points.emplace_back(1.0F, 0.02F * static_cast<float>(column - 30),
                                      0.02F * static_cast<float>(row - 30));
    LiveScan live;
    live.scan = scan;
    const LiveSettings settings;
    const auto least = static_cast<std::size_t>(settings.fit.leastPoints);
    EXPECT_GT(readyScan(live, {}, Pose::Identity(), settings).reduced.size(), least);
    const PointCloud again = reducedAgain(*scan, settings.match);
    EXPECT_GT(again.size(), least);
    EXPECT_EQ(again.normals.size(), again.size());
}

}  // namespace
}  // namespace leitstand
