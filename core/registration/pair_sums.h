#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace leitstand {

/// Weighted sums over point pairs: all that a closed form needs. Source and target points may be in different
/// frames.
struct PairSums {
    std::size_t count = 0;                              ///< number of pairs
    double weight = 0.0;                                ///< sum of the weights
    Eigen::Vector3d source = Eigen::Vector3d::Zero();   ///< sum of the source points [m]
    Eigen::Vector3d target = Eigen::Vector3d::Zero();   ///< sum of the target points [m]
    Eigen::Matrix3d product = Eigen::Matrix3d::Zero();  ///< sum of source * target^T [m^2]
    double squaredDistances = 0.0;  ///< weighted sum over the pairs, at the source's current pose [m^2]

    /// Adds a pair. @p pairWeight: w in the paper's equation (1).
    void add(const Eigen::Vector3d& sourcePoint, const Eigen::Vector3d& targetPoint, double pairWeight = 1.0);
    PairSums& operator+=(const PairSums& other);

    [[nodiscard]] Eigen::Vector3d sourceMean() const { return source / weight; }
    [[nodiscard]] Eigen::Vector3d targetMean() const { return target / weight; }
    /// Weighted sum of (source - sourceMean()) * (target - targetMean())^T [m^2]: the transpose of the matrix
    /// H of equation (7) in the paper.
    [[nodiscard]] Eigen::Matrix3d covariance() const;
    /// Root of the mean squared distance of the pairs [m]; 0 without pairs.
    [[nodiscard]] double rms() const;
};

}  // namespace leitstand
