#include <gtest/gtest.h>
#include <pcl/kdtree/kdtree_flann.h>

#include "core/cloud/filters/range_filter.h"
#include "core/cloud/search/kd_tree.h"
#include "tests/hall/hall.h"
#include "tests/support/rooms.h"
#include "tests/support/shared_data.h"

namespace leitstand {
namespace {

/// Our nearest neighbours of @p queries are as near as those of PCL's KdTreeFLANN.
void expectAsNearAsPcl(const std::vector<Eigen::Vector3f>& model,
                       const std::vector<Eigen::Vector3f>& queries) {
    const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    for (const Eigen::Vector3f& point : model) cloud->emplace_back(point.x(), point.y(), point.z());
    pcl::KdTreeFLANN<pcl::PointXYZ> peer;
    peer.setInputCloud(cloud);
    const KdTree tree(model);
    std::vector<int> index(1);
    std::vector<float> squared(1);
    for (const Eigen::Vector3f& query : queries) {
        ASSERT_EQ(peer.nearestKSearch(pcl::PointXYZ(query.x(), query.y(), query.z()), 1, index, squared), 1);
        const Neighbour found = tree.nearest(query);
        ASSERT_TRUE(found.found());
        ASSERT_NEAR(std::sqrt(found.squaredDistance), std::sqrt(squared[0]), 1e-6);
    }
}

TEST(NearestNeighbours, EqualPclsInAGeneratedRoom) {
    expectAsNearAsPcl(test::roomCloud(20'000, 1).points, test::roomCloud(5'000, 2).points);
}

TEST(NearestNeighbours, EqualPclsInTheHall) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const auto scans = test::hallScans(hall);
    const PointCloud model = pointsInRange(*scans[0], {}, 0.48, 25.0),
                     source = pointsInRange(*scans[1], {}, 0.48, 25.0);
    expectAsNearAsPcl(model.points, test::moved(test::odometryStep(scans, 0), source).points);
}

}  // namespace
}  // namespace leitstand
