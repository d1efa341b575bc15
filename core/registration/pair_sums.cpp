#include "core/registration/pair_sums.h"

#include <cmath>

namespace leitstand {

void PairSums::add(const Eigen::Vector3d& sourcePoint, const Eigen::Vector3d& targetPoint,
                   double pairWeight) {
    const Eigen::Vector3d weighted = pairWeight * sourcePoint;
    ++count;
    weight += pairWeight;
    source += weighted;
    target += pairWeight * targetPoint;
    product.noalias() += weighted * targetPoint.transpose();
    squaredDistances += pairWeight * (sourcePoint - targetPoint).squaredNorm();
}

PairSums& PairSums::operator+=(const PairSums& other) {
    count += other.count;
    weight += other.weight;
    source += other.source;
    target += other.target;
    product += other.product;
    squaredDistances += other.squaredDistances;
    return *this;
}

Eigen::Matrix3d PairSums::covariance() const {
    return product - source * target.transpose() / weight;
}

double PairSums::rms() const {
    return count == 0 ? 0.0 : std::sqrt(squaredDistances / weight);
}

}  // namespace leitstand
