#include "core/registration/closed_forms.h"

#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

struct Method {
    std::string name;
    std::function<Fit(const PairSums&)> fit;
};

void PrintTo(const Method& method, std::ostream* out) {
    *out << method.name;
}

using Points = std::vector<Eigen::Vector3d>;

Points randomPoints(std::size_t count, std::mt19937& random, const Eigen::Vector3d& size = {8, 6, 2.6}) {
    std::uniform_real_distribution<double> within(-0.5, 0.5);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back(size.cwiseProduct(Eigen::Vector3d(within(random), within(random), within(random))) +
                         Eigen::Vector3d(3, -2, 1));
    }
    return points;
}

Pose randomPose(std::mt19937& random) {
    std::uniform_real_distribution<double> angle(-3.1, 3.1), metres(-20, 20);
    return poseFrom({metres(random), metres(random), metres(random)}, angle(random), angle(random) / 2.1,
                    angle(random));
}

PairSums sumsOf(const Points& source, const Points& target) {
    PairSums sums;
    for (std::size_t i = 0; i < source.size(); ++i) sums.add(source[i], target[i]);
    return sums;
}

Points movedBy(const Pose& pose, const Points& points) {
    Points result;
    for (const Eigen::Vector3d& point : points) result.push_back(pose * point);
    return result;
}

class ClosedForm : public testing::TestWithParam<Method> {};

TEST_P(ClosedForm, FindsRandomMotionsExactly) {
    std::mt19937 random(1);
    for (int run = 0; run < 200; ++run) {
        const Points source = randomPoints(run == 0 ? 3 : 40, random);
        const Pose motion = randomPose(random);
        const Fit fit = GetParam().fit(sumsOf(source, movedBy(motion, source)));
        EXPECT_EQ(fit.outcome, FitOutcome::Ok);
        EXPECT_LT(distanceBetween(fit.pose, motion), 1e-8) << "run " << run;
        EXPECT_LT(angleBetween(fit.pose, motion), 1e-9) << "run " << run;
    }
}

TEST_P(ClosedForm, AgreesWithSvdOnNoisyPairs) {
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0.0, 0.05);
    for (int run = 0; run < 100; ++run) {
        const Points source = randomPoints(60, random);
        Points target = movedBy(randomPose(random), source);
        for (Eigen::Vector3d& point : target)
            point += Eigen::Vector3d(noise(random), noise(random), noise(random));
        const PairSums sums = sumsOf(source, target);
        const Fit fit = GetParam().fit(sums), reference = fitBySvd(sums);
        EXPECT_EQ(fit.outcome, FitOutcome::Ok);
        EXPECT_LT(distanceBetween(fit.pose, reference.pose), 1e-8);
        EXPECT_LT(angleBetween(fit.pose, reference.pose), 1e-9);
    }
}

TEST_P(ClosedForm, PointsInAPlaneAreEnough) {
    std::mt19937 random(3);
    for (int run = 0; run < 50; ++run) {
        const Points source = randomPoints(30, random, {5, 4, 0});
        const Pose motion = randomPose(random);
        const Fit fit = GetParam().fit(sumsOf(source, movedBy(motion, source)));
        EXPECT_EQ(fit.outcome, FitOutcome::Ok);
        EXPECT_LT(distanceBetween(fit.pose, motion), 1e-6);
        EXPECT_LT(angleBetween(fit.pose, motion), 1e-7);
    }
}

TEST_P(ClosedForm, ReportsFewerThanThreePairs) {
    std::mt19937 random(4);
    for (std::size_t count = 0; count < 3; ++count) {
        const Points source = randomPoints(count, random);
        const Fit fit = GetParam().fit(sumsOf(source, source));
        EXPECT_EQ(fit.outcome, FitOutcome::TooFewPairs);
        EXPECT_TRUE(fit.pose.isApprox(Pose::Identity()));
    }
}

TEST_P(ClosedForm, ReportsPointsOnALineAndOnASpot) {
    std::mt19937 random(5);
    for (int run = 0; run < 50; ++run) {
        const Points line = movedBy(randomPose(random), randomPoints(20, random, {6, 0, 0}));
        const Fit fit = GetParam().fit(sumsOf(line, movedBy(randomPose(random), line)));
        EXPECT_EQ(fit.outcome, FitOutcome::Collinear);
        EXPECT_TRUE(fit.pose.matrix().allFinite());
        EXPECT_NEAR(fit.pose.linear().determinant(), 1.0, 1e-9);
    }
    const Points spot(10, Eigen::Vector3d(1, 2, 3));
    const Fit fit = GetParam().fit(sumsOf(spot, spot));
    EXPECT_EQ(fit.outcome, FitOutcome::Collinear);
    EXPECT_TRUE(fit.pose.matrix().allFinite());
}

TEST_P(ClosedForm, ReportsMirrorImagesAndStaysARotation) {
    std::mt19937 random(6);
    for (int run = 0; run < 50; ++run) {
        const Points source = randomPoints(40, random);
        Points target;
        for (const Eigen::Vector3d& point : source) target.emplace_back(-point.x(), point.y(), point.z());
        const PairSums sums = sumsOf(source, movedBy(randomPose(random), target));
        const Fit fit = GetParam().fit(sums);
        EXPECT_EQ(fit.outcome, FitOutcome::Mirror);
        EXPECT_NEAR(fit.pose.linear().determinant(), 1.0, 1e-9);
        EXPECT_LT(angleBetween(fit.pose, fitBySvd(sums).pose), 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(All, ClosedForm,
                         testing::Values(Method{"Svd", fitBySvd}, Method{"Quaternion", fitByQuaternion},
                                         Method{"Orthonormal", fitByOrthonormal},
                                         Method{"DualQuaternion", fitByDualQuaternion}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace leitstand
