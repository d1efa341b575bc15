#include "robots/control/link_trail.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

TEST(LinkTrail, LeadsBackTheWayItCame) {
    LinkTrail trail(0.3);
    const auto at = [](double x, double y) { return poseFrom({x, y, 0.0}, 0.0, 0.0, 0.0); };
    trail.moved(at(1.0, 0.0), true, false);
    EXPECT_TRUE(trail.isBack());
    for (double x = 1.0; x < 3.0; x += 0.1) trail.moved(at(x, 0.0), false, false);
    for (double y = 0.0; y < 2.0; y += 0.1) trail.moved(at(3.0, y), false, false);
    EXPECT_FALSE(trail.isBack());
    Eigen::Vector2d here(3.0, 2.0);
    double beside = 0.0;
    for (int i = 0; i < 200 && !trail.isBack(); ++i) {
        trail.moved(at(here.x(), here.y()), false, true);
        const Eigen::Vector2d off = trail.next().head<2>() - here;
        here += std::min(0.05, off.norm()) * off.normalized();
        beside = std::max(beside, std::min(std::abs(here.y()), std::abs(here.x() - 3.0)));
    }
    EXPECT_TRUE(trail.isBack());
    EXPECT_LT((here - Eigen::Vector2d(1.0, 0.0)).norm(), 0.35);
    EXPECT_LT(beside, 0.35) << "round the corner, not through the wall";
}

TEST(LinkTrail, LeadsBackAlsoWhereHeightsDrift) {
    LinkTrail trail(0.3);
    const auto at = [](double x, double z) { return poseFrom({x, 0.0, z}, 0.0, 0.0, 0.0); };
    trail.moved(at(0.0, 0.0), true, false);
    for (double x = 0.0; x < 3.0; x += 0.1) trail.moved(at(x, 0.0), false, false);
    for (double x = 3.0; x > -0.05; x -= 0.1) trail.moved(at(x, 0.4), false, true);
    EXPECT_TRUE(trail.isBack());
}

}  // namespace
}  // namespace leitstand::test
