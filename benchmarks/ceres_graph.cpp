#include "benchmarks/ceres_graph.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

#include <ceres/ceres.h>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace leitstand::benchmarks {
namespace {

struct Variables {
    std::array<double, 3> place;
    std::array<double, 4> turn;  ///< x, y, z, w
};

/// linkError(), weighed by the root of the link's information.
struct Term {
    Eigen::Vector3d place;
    Eigen::Quaterniond turn;
    Information root;

    template <class T>
    bool operator()(const T* fromPlace, const T* fromTurn, const T* toPlace, const T* toTurn,
                    T* error) const {
        using Vector = Eigen::Matrix<T, 3, 1>;
        using Quaternion = Eigen::Quaternion<T>;
        const Quaternion fromBack = Eigen::Map<const Quaternion>(fromTurn).conjugate();
        const Quaternion linkBack = turn.conjugate().cast<T>();
        const Quaternion rest = linkBack * fromBack * Eigen::Map<const Quaternion>(toTurn);
        const Vector moved =
            fromBack * (Eigen::Map<const Vector>(toPlace) - Eigen::Map<const Vector>(fromPlace)) -
            place.cast<T>();
        Eigen::Map<Eigen::Matrix<T, 6, 1>> result(error);
        result.template head<3>() = linkBack * moved;
        result.template tail<3>() = (rest.w() < T(0) ? T(-2) : T(2)) * rest.vec();
        result.applyOnTheLeft(root.cast<T>());
        return true;
    }
};

}  // namespace

CeresResult solveByCeres(const PoseGraph& graph) {
    std::map<std::uint64_t, Variables> nodes;
    for (const GraphNode& node : graph.nodes) {
        Variables& variables = nodes[node.id];
        Eigen::Map<Eigen::Vector3d>(variables.place.data()) = node.pose.translation();
        Eigen::Map<Eigen::Vector4d>(variables.turn.data()) = Eigen::Quaterniond(node.pose.linear()).coeffs();
    }
    ceres::Problem problem;
    for (const Link& link : graph.links) {
        Variables &from = nodes.at(link.from), &to = nodes.at(link.to);
        auto* const term = new Term{link.pose.translation(), Eigen::Quaterniond(link.pose.linear()),
                                    link.information.llt().matrixU()};
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Term, 6, 3, 4, 3, 4>(term), nullptr,
                                 from.place.data(), from.turn.data(), to.place.data(), to.turn.data());
    }
    for (auto& [id, variables] : nodes) {
        if (problem.HasParameterBlock(variables.turn.data()))
            problem.SetManifold(variables.turn.data(), new ceres::EigenQuaternionManifold);
    }
    problem.SetParameterBlockConstant(nodes.begin()->second.place.data());
    problem.SetParameterBlockConstant(nodes.begin()->second.turn.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = 200;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return {summary.final_cost, static_cast<int>(summary.iterations.size())};
}

}  // namespace leitstand::benchmarks
