#include "core/mapping/metascan.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand {
namespace {

/// A large scan, and smaller ones of partly the same ground a little aside.
void fill(Metascan& metascan) {
    metascan.add(test::roomCloud(60'000, 1), Pose::Identity());
    for (unsigned i = 1; i < 4; ++i)
        metascan.add(test::roomCloud(2'000, i + 1), poseFrom({0.02 * i, 0, 0.01}, 0, 0, degrees(2.0 * i)));
}

TEST(Metascan, FindsWhatASearchOverAllOfItFinds) {
    for (const SearchMethod method : {SearchMethod::BruteForce, SearchMethod::KdTree, SearchMethod::Forest}) {
        Metascan metascan({.voxel = 0.05, .search = method});
        fill(metascan);
        const PointCloud& cloud = metascan.cloud();
        const auto whole = makeSearch(cloud, method);
        const PointCloud asked = test::moved(poseFrom({0.1, 0.2, 0.05}, 0, 0, 0.2), test::roomCloud(300, 9));
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const Neighbour found = metascan.search().nearest(asked.points[i], asked.labels[i], 0.04F);
            const Neighbour wanted = whole->nearest(asked.points[i], asked.labels[i], 0.04F);
            ASSERT_EQ(found.found(), wanted.found());
            if (!found.found()) continue;
            EXPECT_FLOAT_EQ(found.squaredDistance, wanted.squaredDistance);
            EXPECT_FLOAT_EQ((cloud.points[std::size_t(found.index)] - asked.points[i]).squaredNorm(),
                            found.squaredDistance);
        }
    }
}

TEST(Metascan, GroundThatIsSeenAgainStaysWhereItLies) {
    Metascan metascan({.voxel = 0.05});
    metascan.add(test::roomCloud(60'000, 1), Pose::Identity());
    const PointCloud first = metascan.cloud();
    EXPECT_LT(first.size(), 60'000U);
    EXPECT_EQ(first.normals.size(), first.size());
    EXPECT_EQ(first.labels.size(), first.size());
    metascan.add(test::roomCloud(5'000, 2), poseFrom({0.01, 0, 0.01}, 0, 0, 0));
    ASSERT_GE(metascan.cloud().size(), first.size());
    EXPECT_TRUE(std::equal(first.points.begin(), first.points.end(), metascan.cloud().points.begin()));
}

TEST(Metascan, AVoxelOfLatelyKeepsTheMeanOfItsPoints) {
    Metascan metascan({.voxel = 0.1});
    metascan.add({{{0.02F, 0.05F, 0.05F}}, {{0, 0, 1}}, {Label::Floor}, {}}, Pose::Identity());
    metascan.add({{{0.06F, 0.05F, 0.05F}}, {{0, 0, 1}}, {Label::Floor}, {}}, Pose::Identity());
    ASSERT_EQ(metascan.cloud().size(), 1U);
    EXPECT_FLOAT_EQ(metascan.cloud().points[0].x(), 0.04F);
    EXPECT_TRUE(metascan.search().nearest({0.04F, 0.05F, 0.05F}, Label::Floor, 1e-6F).found());
}

TEST(Metascan, OfNothingFindsNothing) {
    Metascan metascan({});
    metascan.add({}, Pose::Identity());
    EXPECT_TRUE(metascan.cloud().points.empty());
    EXPECT_FALSE(metascan.search().nearest({0, 0, 0}, Label::Unlabelled, 1.0F).found());
}

}  // namespace
}  // namespace leitstand
