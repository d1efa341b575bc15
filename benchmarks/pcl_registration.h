#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand::benchmarks {

/// PCL's registration with a small interface. PCL's headers take long to compile and are included in only one
/// source file.
class PclRegistration {
public:
    PclRegistration(const std::vector<Eigen::Vector3f>& target, const std::vector<Eigen::Vector3f>& source);
    ~PclRegistration();

    /// pcl::IterativeClosestPoint with a search that was built before. Returns the number of iterations.
    int icp(const Pose& guess, double maxDistance, int iterations);
    /// pcl::GeneralizedIterativeClosestPoint with its defaults, including covariances and search. Returns the
    /// pose of the source in the target.
    Pose gicp(const Pose& guess, double maxDistance);
    /// The same for clouds reduced by pcl::VoxelGrid, including the filter.
    Pose gicpOfVoxels(const Pose& guess, double maxDistance, float edge);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand::benchmarks
