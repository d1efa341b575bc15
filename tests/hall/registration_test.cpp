#include <cstdio>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/mapping/offline_mapper.h"
#include "core/mapping/scan_preparation.h"
#include "tests/hall/hall.h"
#include "tests/support/shared_data.h"

// References and consensus: ../shared/data/README.md.

namespace leitstand {
namespace {

RegistrationSettings allPoints() {
    RegistrationSettings settings;
    settings.reduce = 0.0;
    settings.minRange = 0.48;
    settings.maxRange = 25.0;
    settings.maxDistances = {0.25};
    return settings;
}

MapPtr mapOf(const std::vector<ScanPtr>& scans, const RegistrationSettings& settings) {
    OfflineMapper mapper(settings);
    for (const ScanPtr& scan : scans) EXPECT_TRUE(mapper.add(scan));
    return mapper.map();
}

void print(const std::string& what, const Pose& pose, const Pose& reference, const IcpResult& icp) {
    fmt::print(
        "[          ] {}: off by {:.1f} mm and {:.3f} degrees after {} iterations, rms {:.1f} mm, certainty "
        "{:.3f}\n",
        what, 1e3 * distanceBetween(pose, reference), inDegrees(angleBetween(pose, reference)),
        icp.iterations, 1e3 * icp.rms, icp.certainty);
}

class HallPointToPoint : public testing::TestWithParam<Minimizer> {};

TEST_P(HallPointToPoint, EndsAtTheReferencePoses) {
    LEITSTAND_HALL_OR_SKIP(hall);
    RegistrationSettings settings = allPoints();
    settings.minimizer = GetParam();
    const MapPtr map = mapOf(test::hallScans(hall), settings);
    const Pose references[] = {test::poseFromRows({.999827, -.012833, .013451, 1.56815, .012902, .999904,
                                                   -.005051, .03646, -.013385, .005224, .999897, -.09057}),
                               test::poseFromRows({.999946, -.005569, -.008816, 3.36059, .005631, .999959,
                                                   .007108, .07783, .008776, -.007157, .999936, -.18358})};
    for (std::size_t i = 0; i < 2; ++i) {
        const MapScan& scan = map->scans[i + 1];
        print(scan.scan->name, scan.poseInMap, references[i], scan.icp);
        EXPECT_TRUE(scan.icp.converged);
        EXPECT_LT(distanceBetween(scan.poseInMap, references[i]), 0.005);
        EXPECT_LT(inDegrees(angleBetween(scan.poseInMap, references[i])), 0.1);
    }
}

INSTANTIATE_TEST_SUITE_P(All, HallPointToPoint,
                         testing::Values(Minimizer::Svd, Minimizer::Quaternion, Minimizer::Orthonormal,
                                         Minimizer::DualQuaternion));

TEST(HallGicp, EndsAtThePairConsensus) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const auto scans = test::hallScans(hall);
    const MapPtr map = mapOf(scans, allPoints());
    const Pose consensus[] = {test::poseFromRows({.999641, -.013261, .023274, 1.561930, .013473, .999869,
                                                  -.008988, .040855, -.023152, .009299, .999689, -.076320}),
                              test::poseFromRows({.999803, .005906, -.018969, 1.829549, -.005819, .999972,
                                                  .004608, .020335, .018996, -.004497, .999809, -.060174})};
    for (std::size_t i = 0; i < 2; ++i) {
        const MapScan& scan = map->scans[i + 1];
        const Pose step = map->scans[i].poseInMap.inverse() * scan.poseInMap;
        print(scan.scan->name, step, consensus[i], scan.icp);
        EXPECT_TRUE(scan.icp.converged);
        EXPECT_LT(distanceBetween(step, consensus[i]), 0.03);
        EXPECT_LT(inDegrees(angleBetween(step, consensus[i])), 1.0);
    }
}

/// A turn of up to @p angle [rad] about a random axis and a shift of up to @p distance [m].
Pose randomMotion(std::mt19937& random, double distance, double angle) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const auto direction = [&] {
        return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    };
    Pose motion = Pose::Identity();
    motion.linear() = Eigen::AngleAxisd(angle * share(random), direction()).toRotationMatrix();
    motion.translation() = distance * share(random) * direction();
    return motion;
}

TEST(HallConvergence, PerturbedStartsComeBackInFortyOfForty) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const auto scans = test::hallScans(hall);
    RegistrationSettings settings;
    settings.minRange = 0.48;
    settings.maxRange = 25.0;
    std::mt19937 random(2005);
    int back = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const PointCloud target = prepared(*scans[i], settings), source = prepared(*scans[i + 1], settings);
        const auto search = makeSearch(target, SearchMethod::KdTree);
        IcpSettings icp;
        icp.maxDistances = {1.5, 0.5};
        const Pose start = test::odometryStep(scans, i);
        const IcpResult unperturbed = align(target, *search, source, start, icp);
        EXPECT_TRUE(unperturbed.converged);
        for (int run = 0; run < 20; ++run) {
            const IcpResult result =
                align(target, *search, source, start * randomMotion(random, 1.0, degrees(20)), icp);
            const double distance = distanceBetween(result.pose, unperturbed.pose);
            const double angle = inDegrees(angleBetween(result.pose, unperturbed.pose));
            const bool good = distance < 0.02 && angle < 0.5;
            back += good ? 1 : 0;
            EXPECT_TRUE(good) << "pair " << i << " run " << run << ": " << distance << " m, " << angle
                              << " degrees, " << result.iterations << " iterations";
        }
    }
    fmt::print("[          ] {} of 40 perturbed starts came back\n", back);
    EXPECT_EQ(back, 40);
}

}  // namespace
}  // namespace leitstand
