#include "core/mapping/metascan.h"

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand {
namespace {

TEST(Metascan, FindsWhatASearchOverAllOfItFinds) {
    for (const SearchMethod method : {SearchMethod::KdTree, SearchMethod::Forest}) {
        Metascan metascan({.voxel = 0.04, .search = method});
        for (unsigned i = 0; i < 4; ++i)
            metascan.add(test::roomCloud(40'000, i + 1), poseFrom({0.5 * i, 0, 0}, 0, 0, degrees(10.0 * i)));
        const PointCloud& cloud = metascan.cloud();
        EXPECT_GT(cloud.size(), 50'000U) << "more than what is indexed anew each time";
        const auto whole = makeSearch(cloud, method);
        const PointCloud asked = test::moved(poseFrom({0.1, 0.2, 0.05}, 0, 0, 0.2), test::roomCloud(500, 9));
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

TEST(Metascan, GroundThatIsSeenAgainStaysWhereItWasFirstSeen) {
    Metascan metascan({.voxel = 0.1});
    const PointCloud room = test::roomCloud(20'000, 1);
    metascan.add(room, Pose::Identity());
    const PointCloud first = metascan.cloud();
    EXPECT_LT(first.size(), room.size());
    EXPECT_EQ(first.normals.size(), first.size());
    EXPECT_EQ(first.labels.size(), first.size());
    metascan.add(room, Pose::Identity());
    EXPECT_EQ(metascan.cloud().points, first.points);
}

TEST(Metascan, OfNothingFindsNothing) {
    Metascan metascan({});
    metascan.add({}, Pose::Identity());
    EXPECT_TRUE(metascan.cloud().points.empty());
    EXPECT_FALSE(metascan.search().nearest({0, 0, 0}, Label::Unlabelled, 1.0F).found());
}

}  // namespace
}  // namespace leitstand
