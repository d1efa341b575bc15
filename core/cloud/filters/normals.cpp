#include "core/cloud/filters/normals.h"

#include <cstddef>

#include <Eigen/Eigenvalues>

#include "core/base/parallel.h"
#include "core/cloud/filters/grid_tangents.h"
#include "core/cloud/search/kd_tree.h"

namespace leitstand {
namespace {

/// Normal of the plane through @p near of @p points, towards @p sensor; zero if they do not span one.
Eigen::Vector3f planeNormal(std::span<const Eigen::Vector3f> points, const std::vector<Neighbour>& near,
                            const Eigen::Vector3f& sensor) {
    constexpr double LeastWidth = 1e-3;  // squared width of a plane over its length
    if (near.size() < 3) return Eigen::Vector3f::Zero();
    const Eigen::Vector3f& origin = points[static_cast<std::size_t>(near.front().index)];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Neighbour& neighbour : near) {
        const Eigen::Vector3d offset =
            (points[static_cast<std::size_t>(neighbour.index)] - origin).cast<double>();
        sum += offset;
        squares.selfadjointView<Eigen::Lower>().rankUpdate(offset);
    }
    const auto count = static_cast<double>(near.size());
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    squares.selfadjointView<Eigen::Lower>().rankUpdate(sum, -1.0 / count);
    solver.computeDirect(squares);
    const Eigen::Vector3d& values = solver.eigenvalues();
    if (!(values[1] > LeastWidth * values[2])) return Eigen::Vector3f::Zero();
    const Eigen::Vector3f normal = solver.eigenvectors().col(0).cast<float>();
    return normal.dot(sensor - origin) < 0.0F ? Eigen::Vector3f(-normal) : normal;
}

}  // namespace

std::vector<Eigen::Vector3f> gridNormals(const Scan& scan, int threads) {
    return gridNormals(scan, gridTangents(scan, threads), threads);
}

std::vector<Eigen::Vector3f> gridNormals(const Scan& scan, const GridTangents& tangents, int threads) {
    constexpr std::size_t Grain = 8192;
    std::vector<Eigen::Vector3f> normals(scan.points.size());
    parallelFor(normals.size(), Grain, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) normals[i] = tangents.normal(i, scan.points[i]);
    });
    return normals;
}

std::vector<Eigen::Vector3f> knnNormals(std::span<const Eigen::Vector3f> points, int neighbours,
                                        const Eigen::Vector3f& sensor, int threads) {
    constexpr std::size_t Grain = 1024;
    const KdTree tree(points);
    std::vector<Eigen::Vector3f> normals(points.size(), Eigen::Vector3f::Zero());
    parallelFor(points.size(), Grain, threads, [&](std::size_t first, std::size_t last) {
        std::vector<Neighbour> near;
        for (std::size_t i = first; i < last; ++i) {
            if (!points[i].allFinite()) continue;
            tree.kNearest(points[i], static_cast<std::size_t>(neighbours), near);
            normals[i] = planeNormal(points, near, sensor);
        }
    });
    return normals;
}

}  // namespace leitstand
