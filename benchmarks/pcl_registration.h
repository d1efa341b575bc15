#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand::benchmarks {

/// PCL's registration behind a small door: its headers take long to compile and stand in one source only.
class PclRegistration {
public:
    PclRegistration(const std::vector<Eigen::Vector3f>& target, const std::vector<Eigen::Vector3f>& source);
    ~PclRegistration();

    /// pcl::IterativeClosestPoint over a search that is built beforehand; the iterations it ran.
    int icp(const Pose& guess, double maxDistance, int iterations);
    /// pcl::GeneralizedIterativeClosestPoint with its defaults, covariances and search included; source in
    /// target.
    Pose gicp(const Pose& guess, double maxDistance);
    /// The same on clouds reduced by pcl::VoxelGrid, filter included.
    Pose gicpOfVoxels(const Pose& guess, double maxDistance, float edge);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand::benchmarks
