#include "core/registration/pair_sums.h"

#include <cmath>

namespace leitstand {

void PairSums::add(const Eigen::Vector3d& sourcePoint, const Eigen::Vector3d& targetPoint) {
    ++count;
    source += sourcePoint;
    target += targetPoint;
    product.noalias() += sourcePoint * targetPoint.transpose();
    squaredDistances += (sourcePoint - targetPoint).squaredNorm();
}

PairSums& PairSums::operator+=(const PairSums& other) {
    count += other.count;
    source += other.source;
    target += other.target;
    product += other.product;
    squaredDistances += other.squaredDistances;
    return *this;
}

Eigen::Matrix3d PairSums::covariance() const {
    return product - source * target.transpose() / static_cast<double>(count);
}

double PairSums::rms() const {
    return count == 0 ? 0.0 : std::sqrt(squaredDistances / static_cast<double>(count));
}

}  // namespace leitstand
