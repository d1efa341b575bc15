#include <cstdio>

#include <gtest/gtest.h>

#include "core/cloud/filters/median_filter.h"
#include "core/cloud/filters/normals.h"
#include "core/cloud/filters/outliers.h"
#include "core/cloud/filters/range_filter.h"
#include "tests/hall/hall.h"
#include "tests/support/shared_data.h"

namespace leitstand::test {
namespace {

TEST(HallReduction, TheMedianFilterLeavesAboutATenth) {
    LEITSTAND_HALL_OR_SKIP(folder);
    for (const ScanPtr& scan : hallScans(folder)) {
        const auto normals = gridNormals(*scan);
        const PointCloud all = pointsInRange(*scan, normals, 0.4, 30.0);
        const PointCloud reduced = medianReduced(*scan, normals);
        const double left = static_cast<double>(reduced.size()) / static_cast<double>(all.size());
        std::printf("%s: %zu of %zu points left, %.1f %%\n", scan->name.c_str(), reduced.size(), all.size(),
                    100.0 * left);
        EXPECT_GT(left, 0.05);
        EXPECT_LT(left, 0.18);
        EXPECT_EQ(reduced.normals.size(), reduced.size());
        EXPECT_EQ(reduced.labels.size(), reduced.size());
    }
}

TEST(HallReduction, FewPointsAreMixedPixelsOrIsolated) {
    LEITSTAND_HALL_OR_SKIP(folder);
    for (const ScanPtr& scan : hallScans(folder)) {
        const PointCloud all = pointsInRange(*scan, {}, 0.4, 30.0);
        const PointCloud solid = pointsInRange(withoutMixedPixels(*scan), {}, 0.4, 30.0);
        const PointCloud dense = withoutIsolated(all);
        std::printf("%s: %zu mixed pixels, %zu isolated of %zu points\n", scan->name.c_str(),
                    all.size() - solid.size(), all.size() - dense.size(), all.size());
        EXPECT_GT(solid.size(), all.size() * 95 / 100);
        EXPECT_LT(solid.size(), all.size());
        EXPECT_GT(dense.size(), all.size() * 95 / 100);
    }
}

}  // namespace
}  // namespace leitstand::test
