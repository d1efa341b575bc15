#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "core/cloud/filters/range_filter.h"
#include "tests/hall/hall.h"
#include "tests/support/shared_data.h"

namespace leitstand::test {
namespace {

/// The value below which a tenth, half and nine tenths of @p values are.
std::array<float, 3> tenthHalfNine(std::vector<float> values) {
    std::sort(values.begin(), values.end());
    return {values[values.size() / 10], values[values.size() / 2], values[values.size() * 9 / 10]};
}

TEST(HallLabels, FloorLiesLowCeilingHighAndLittleIsLeftOpen) {
    LEITSTAND_HALL_OR_SKIP(folder);
    for (const ScanPtr& scan : hallScans(folder)) {
        const PointCloud cloud = pointsInRange(*scan, {}, 0.48, 25.0);
        std::array<std::vector<float>, LabelCount> heights;
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            heights[static_cast<std::size_t>(cloud.labels[i])].push_back(cloud.points[i].z());
        }
        const auto share = [&](Label label) {
            return 100.0 * static_cast<double>(heights[static_cast<std::size_t>(label)].size()) /
                   static_cast<double>(cloud.size());
        };
        const auto floor = tenthHalfNine(heights[1]), ceiling = tenthHalfNine(heights[3]);
        std::printf(
            "%s: %.1f %% unlabelled, %.1f %% floor (%.2f %.2f %.2f m), %.1f %% wall, %.1f %% ceiling "
            "(%.2f %.2f %.2f m)\n",
            scan->name.c_str(), share(Label::Unlabelled), share(Label::Floor), floor[0], floor[1], floor[2],
            share(Label::Wall), share(Label::Ceiling), ceiling[0], ceiling[1], ceiling[2]);
        EXPECT_LT(share(Label::Unlabelled), 4.0);
        EXPECT_GT(share(Label::Floor), 10.0);
        EXPECT_GT(share(Label::Ceiling), 5.0);
        EXPECT_LT(floor[1], -0.3F);
        EXPECT_LT(floor[2] - floor[0], 0.5F);
        EXPECT_GT(ceiling[1], 1.5F);
    }
}

}  // namespace
}  // namespace leitstand::test
