#include "core/mapping/calibration/range_bias.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/cloud/search/search.h"

namespace leitstand {
namespace {

using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;

constexpr std::array<float, 3> Within = {0.15F, 0.1F, 0.1F};  ///< pairs, one round each [m]
constexpr float Alike = 0.9F;                                 ///< cosine between the normals of a pair
constexpr double Outlier = 0.02;         ///< pairs farther apart count half, or less (Cauchy) [m]
constexpr std::size_t LeastPairs = 300;  ///< of points
constexpr double PairDeviation = 0.015;  ///< of a pair of points, across its surface [m]
constexpr double Open = 1e-7;  ///< least ratio of the smallest to the largest pivot; below: under-constrained
constexpr double MostDeviation = 0.004;  ///< largest of the bias by one pair of scans [m]
constexpr std::size_t Enough = 12;       ///< pairs of scans for an estimate
constexpr std::size_t Most = 400;        ///< pairs of scans that are kept

/// Returns the median of @p values, which must not be empty, and reorders them.
double medianOf(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

bool RangeBias::add(const PointCloud& scan, const PointCloud& other, const Pose& scanInOther) {
    if (scan.normals.size() != scan.size() || other.normals.size() != other.size() || other.points.empty())
        return false;
    const auto search = makeSearch(other, SearchMethod::KdTree);
    Pose pose = scanInOther;
    double bias = 0.0, deviation = 0.0;
    for (const float within : Within) {
        Matrix7 information = Matrix7::Zero();
        Vector7 gradient = Vector7::Zero();
        std::size_t pairs = 0;
        for (std::size_t i = 0; i < scan.size(); ++i) {
            const Eigen::Vector3d seen = scan.points[i].cast<double>();
            const Eigen::Vector3d ray = pose.linear() * seen.normalized();
            const Eigen::Vector3d point = pose * seen - bias * ray;
            const Neighbour nearest =
                search->nearest(point.cast<float>(), Label::Unlabelled, within * within);
            if (!nearest.found()) continue;
            const auto at = static_cast<std::size_t>(nearest.index);
            const Eigen::Vector3d normal = other.normals[at].cast<double>();
            const Eigen::Vector3d own = pose.linear() * scan.normals[i].cast<double>();
            if (!(normal.dot(own) >= static_cast<double>(Alike))) continue;
            const Eigen::Vector3d across = (normal + own).normalized();
            const Eigen::Vector3d partner = other.points[at].cast<double>();
            const Eigen::Vector3d otherRay = partner.normalized();
            const double residual = across.dot(point - (partner - bias * otherRay));
            const double weight = 1.0 / (1.0 + std::pow(residual / Outlier, 2));
            Vector7 row;
            row << across, (point - pose.translation()).cross(across), -across.dot(ray - otherRay);
            information.noalias() += weight * row * row.transpose();
            gradient += weight * residual * row;
            ++pairs;
        }
        if (pairs < LeastPairs) return false;
        const Eigen::LDLT<Matrix7> factors(information);
        const Vector7 pivots = factors.vectorD();
        if (factors.info() != Eigen::Success || !(pivots.minCoeff() > Open * pivots.maxCoeff())) return false;
        const Vector7 step = factors.solve(-gradient);
        if (!step.allFinite()) return false;
        const Pose motion = poseFromTwist(step.head<6>());
        const Eigen::Vector3d at = pose.translation();
        pose.linear() = motion.linear() * pose.linear();
        pose.translation() = at + motion.translation();
        bias += step[6];
        deviation = PairDeviation * std::sqrt(factors.solve(Vector7::Unit(6))[6]);
    }
    if (!(deviation <= MostDeviation)) return false;
    if (m_reported.size() == Most) m_reported.erase(m_reported.begin());
    m_reported.push_back(bias);
    return true;
}

std::optional<Estimated> RangeBias::estimate() const {
    if (m_reported.size() < Enough) return std::nullopt;
    std::vector<double> values = m_reported;
    const double median = medianOf(values);
    for (double& value : values) value = std::abs(value - median);
    // For normally distributed values: their deviation by the median absolute deviation, and that of a
    // median.
    constexpr double OfMedian = 1.2533, OfAbsolute = 1.4826;
    return Estimated{
        median, OfMedian * OfAbsolute * medianOf(values) / std::sqrt(static_cast<double>(values.size()))};
}

}  // namespace leitstand
