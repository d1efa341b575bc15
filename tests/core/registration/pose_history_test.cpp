#include "core/registration/pose_history.h"

#include <cmath>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

Pose at(double x) {
    return poseFrom({x, 0, 0}, 0, 0, 0);
}

TEST(PoseHistory, AWalkThatGetsSomewhereIsNoCycle) {
    PoseHistory history;
    for (int i = 0; i < 300; ++i) {
        history.add(at(std::pow(0.97, i)), 1.0);
        EXPECT_EQ(history.cycle(1e-9), 0u) << i;
    }
}

TEST(PoseHistory, FindsThePeriodAndTheCheapestPoseOfACycle) {
    for (const int period : {2, 3, 7, 20}) {
        PoseHistory history;
        for (int i = 0; i < 10; ++i) history.add(at(1.0 - 0.05 * i), 2.0);
        std::size_t found = 0;
        int steps = 0;
        for (; found == 0 && steps < 200; ++steps) {
            const int phase = steps % period;
            history.add(at(0.1 * phase), phase == 1 ? 0.5 : 1.0);
            found = history.cycle(1e-6);
        }
        EXPECT_EQ(found, static_cast<std::size_t>(period));
        EXPECT_LE(steps, 2 * period + 2);
        EXPECT_NEAR(history.best(found).translation().x(), 0.1, 1e-12);
        EXPECT_GT(history.extent(found).distance, 0.05) << "too large to pass for converged";
    }
}

TEST(PoseHistory, WanderingOnTheSpotIsACycleToo) {
    PoseHistory history;
    std::size_t found = 0;
    for (int i = 0; i < 100 && found == 0; ++i) {
        // Angles that never repeat.
        history.add(poseFrom({2e-4 * std::cos(i * 2.39996), 2e-4 * std::sin(i * 2.39996), 0}, 0, 0, 0), 1.0);
        found = history.cycle(1e-6);
    }
    EXPECT_GT(found, 0u);
    EXPECT_LE(history.extent(found).distance, PoseHistory::CycleDistance);
}

}  // namespace
}  // namespace leitstand
