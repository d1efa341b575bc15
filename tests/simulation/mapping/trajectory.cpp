#include "tests/simulation/mapping/trajectory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

namespace leitstand::simulation::test {

TrajectoryError errorOf(const Trajectory& trajectory) {
    const auto count = static_cast<Eigen::Index>(trajectory.found.size());
    Eigen::Matrix3Xd found(3, count), truth(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        found.col(i) = trajectory.found[static_cast<std::size_t>(i)].translation();
        truth.col(i) = trajectory.truth[static_cast<std::size_t>(i)].translation();
    }
    Pose mapInArena = Pose::Identity();
    mapInArena.matrix() = Eigen::umeyama(found, truth, false);
    TrajectoryError error;
    for (std::size_t i = 0; i < trajectory.found.size(); ++i) {
        const Pose pose = mapInArena * trajectory.found[i];
        error.distance += (pose.translation() - trajectory.truth[i].translation()).squaredNorm();
        error.height += std::pow(pose.translation().z() - trajectory.truth[i].translation().z(), 2);
        error.angle += std::pow(angleBetween(pose, trajectory.truth[i]), 2);
        const Eigen::Vector3d up = trajectory.found[i].linear().row(2),
                              trueUp = trajectory.truth[i].linear().row(2);
        error.tilt += std::pow(std::atan2(up.cross(trueUp).norm(), up.dot(trueUp)), 2);
    }
    error.mapInArena = mapInArena;
    for (double* sum : {&error.distance, &error.height, &error.angle, &error.tilt})
        *sum = std::sqrt(*sum / static_cast<double>(count));
    return error;
}

double worstSeam(const Trajectory& trajectory) {
    constexpr double Near = 1.5, Apart = 10.0;
    std::vector<double> way = {0.0};
    for (std::size_t i = 1; i < trajectory.truth.size(); ++i)
        way.push_back(way.back() + distanceBetween(trajectory.truth[i - 1], trajectory.truth[i]));
    double worst = 0.0;
    for (std::size_t i = 0; i < trajectory.truth.size(); ++i) {
        for (std::size_t j = 0; j < i && way[i] - way[j] > Apart; ++j) {
            if (distanceBetween(trajectory.truth[i], trajectory.truth[j]) > Near) continue;
            const Pose found = trajectory.found[j].inverse() * trajectory.found[i];
            const Pose truth = trajectory.truth[j].inverse() * trajectory.truth[i];
            worst = std::max(worst, distanceBetween(found, truth));
        }
    }
    return worst;
}

}  // namespace leitstand::simulation::test
