#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/mapping/table1.h"
#include "tests/hall/hall.h"
#include "tests/support/shared_data.h"

namespace leitstand {
namespace {

// Brute force alone takes ten seconds.
TEST(Table1Long, TheForestOnReducedPointsIs17Point9TimesAsFastAsAllPoints) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const auto scans = test::hallScans(hall);
    for (std::size_t pair = 0; pair < 2; ++pair) {
        const auto table = measureTable1(*scans[pair], *scans[pair + 1]);
        ASSERT_TRUE(table) << table.error().text;
        for (const Table1Row& row : *table) {
            fmt::print(
                "[          ] {} points, search {}: {:.1f} ms, {} iterations, {:.1f} times, off by {:.1f} mm "
                "and "
                "{:.2f} degrees\n",
                row.sourcePoints, static_cast<int>(row.search), 1e3 * row.seconds, row.iterations,
                row.speedUp, 1e3 * row.distance, inDegrees(row.angle));
            EXPECT_TRUE(row.counts);
        }
        EXPECT_GE((*table)[4].speedUp, 17.9);
        EXPECT_LT((*table)[4].iterations, (*table)[1].iterations);
    }
}

}  // namespace
}  // namespace leitstand
