#include "benchmarks/pcl_registration.h"

#include <pcl/filters/voxel_grid.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#include <pcl/search/kdtree.h>

namespace leitstand::benchmarks {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr cloudOf(const std::vector<Eigen::Vector3f>& points) {
    const Cloud::Ptr cloud(new Cloud);
    cloud->reserve(points.size());
    for (const Eigen::Vector3f& point : points) cloud->emplace_back(point.x(), point.y(), point.z());
    return cloud;
}

/// Tells how many iterations it ran, which PCL keeps to itself.
class CountingIcp : public pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> {
public:
    [[nodiscard]] int iterations() const { return nr_iterations_; }
};

Cloud::Ptr voxels(const Cloud::Ptr& cloud, float edge) {
    pcl::VoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.setLeafSize(edge, edge, edge);
    const Cloud::Ptr reduced(new Cloud);
    grid.filter(*reduced);
    return reduced;
}

Pose gicpBetween(const Cloud::Ptr& target, const Cloud::Ptr& source, const Pose& guess, double maxDistance) {
    pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> gicp;
    gicp.setInputTarget(target);
    gicp.setInputSource(source);
    gicp.setMaxCorrespondenceDistance(maxDistance);
    Cloud aligned;
    gicp.align(aligned, guess.matrix().cast<float>());
    Pose pose;
    pose.matrix() = gicp.getFinalTransformation().cast<double>();
    return pose;
}

}  // namespace

struct PclRegistration::State {
    Cloud::Ptr target, source;
    pcl::search::KdTree<pcl::PointXYZ>::Ptr search;
};

PclRegistration::PclRegistration(const std::vector<Eigen::Vector3f>& target,
                                 const std::vector<Eigen::Vector3f>& source)
    : m_state(std::make_unique<State>()) {
    m_state->target = cloudOf(target);
    m_state->source = cloudOf(source);
    m_state->search.reset(new pcl::search::KdTree<pcl::PointXYZ>);
    m_state->search->setInputCloud(m_state->target);
}

PclRegistration::~PclRegistration() = default;

int PclRegistration::icp(const Pose& guess, double maxDistance, int iterations) {
    CountingIcp icp;
    icp.setSearchMethodTarget(m_state->search, true);
    icp.setInputTarget(m_state->target);
    icp.setInputSource(m_state->source);
    icp.setMaxCorrespondenceDistance(maxDistance);
    icp.setMaximumIterations(iterations);
    Cloud aligned;
    icp.align(aligned, guess.matrix().cast<float>());
    return icp.iterations();
}

Pose PclRegistration::gicp(const Pose& guess, double maxDistance) {
    return gicpBetween(m_state->target, m_state->source, guess, maxDistance);
}

Pose PclRegistration::gicpOfVoxels(const Pose& guess, double maxDistance, float edge) {
    return gicpBetween(voxels(m_state->target, edge), voxels(m_state->source, edge), guess, maxDistance);
}

}  // namespace leitstand::benchmarks
