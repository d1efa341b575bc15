#include "core/handin/map/voxel_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leitstand {
namespace {

struct Extent {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;

    void add(const Eigen::Vector3d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    [[nodiscard]] bool empty() const { return !(low.x() <= high.x()); }
};

/// Returns the median of the places of scans: a few scans far away must not decide what the map is.
Eigen::Vector3d middleOf(std::span<const ReportScan> scans) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const ReportScan& scan : scans) {
            if (scan.scanInMap.translation().allFinite())
                values.push_back(scan.scanInMap.translation()[axis]);
        }
        if (values.empty()) return middle;
        const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), half, values.end());
        middle[axis] = *half;
    }
    return middle;
}

Extent extentOf(std::span<const ReportScan> scans, const EvidenceSettings& settings) {
    const Eigen::Vector3d middle = middleOf(scans);
    const double half = settings.mostExtent / 2;
    Extent extent;
    const auto take = [&](const Eigen::Vector3d& point) {
        if (((point - middle).cwiseAbs().array() < half).all()) extent.add(point);
    };
    const auto range = static_cast<float>(settings.maxRange);
    for (const ReportScan& scan : scans) {
        if (scan.scan->points.empty()) continue;
        take(scan.scanInMap.translation());
        for (const Eigen::Vector3f& point : scan.scan->points) {
            // NaN is no echo.
            if (point.squaredNorm() <= range * range) take(scan.scanInMap * point.cast<double>());
        }
    }
    return extent;
}

}  // namespace

/// Which cubes the current scan has counted already.
struct VoxelEvidence::Marks {
    static constexpr std::uint16_t Last = 32'000;

    std::vector<std::uint16_t> of;
    std::uint16_t scan = 0;

    void next() {
        if (++scan < Last) return;
        std::fill(of.begin(), of.end(), std::uint16_t{0});
        scan = 1;
    }
    /// Marks @p cube as hit by the current scan; false when it is hit already.
    [[nodiscard]] bool hit(std::size_t cube) {
        const auto mark = static_cast<std::uint16_t>(2 * scan + 1);
        return std::exchange(of[cube], mark) != mark;
    }
    /// Marks @p cube as passed by the current scan; false when it is passed or hit already.
    [[nodiscard]] bool pass(std::size_t cube) {
        const auto mark = static_cast<std::uint16_t>(2 * scan);
        if (of[cube] >= mark) return false;
        of[cube] = mark;
        return true;
    }
};

void VoxelEvidence::change(std::size_t cube, int by) {
    m_values[cube] =
        static_cast<std::int8_t>(std::clamp(m_values[cube] + by, m_settings.least, m_settings.most));
}

/// Passes all cubes from that of @p from to the one before that of @p to (Amanatides & Woo 1987).
void VoxelEvidence::castRay(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Marks& marks) {
    const Eigen::Vector3d a = (from - origin()) / m_cell, way = (to - from) / m_cell;
    Eigen::Vector3i cube = a.array().floor().cast<int>();
    const Eigen::Vector3i last = ((to - origin()) / m_cell).array().floor().cast<int>();
    Eigen::Vector3i step;
    Eigen::Vector3d next, each;
    for (int axis = 0; axis < 3; ++axis) {
        step[axis] = way[axis] > 0.0 ? 1 : -1;
        const double edge = static_cast<double>(cube[axis]) + (way[axis] > 0.0 ? 1.0 : 0.0);
        const bool flat = std::abs(way[axis]) < 1e-9;
        each[axis] = flat ? std::numeric_limits<double>::infinity() : 1.0 / std::abs(way[axis]);
        next[axis] = flat ? std::numeric_limits<double>::infinity() : (edge - a[axis]) / way[axis];
    }
    int most = (last - cube).cwiseAbs().sum();
    for (; most > 0 && cube != last; --most) {
        if ((cube.array() >= 0).all() && (cube.array() < m_size.array()).all()) {
            const std::size_t here = index(cube.x(), cube.y(), cube.z());
            if (marks.pass(here)) change(here, m_settings.miss);
        }
        const int axis = next.x() < next.y() ? (next.x() < next.z() ? 0 : 2) : (next.y() < next.z() ? 1 : 2);
        cube[axis] += step[axis];
        next[axis] += each[axis];
    }
}

void VoxelEvidence::add(const ReportScan& scan, Marks& marks) {
    marks.next();
    const Eigen::Vector3d from = scan.scanInMap.translation();
    const Eigen::Vector3d low = origin(), high = low + m_size.cast<double>() * m_cell;
    const auto inside = [&](const Eigen::Vector3d& point) {
        return (point.array() >= low.array()).all() && (point.array() < high.array()).all();
    };
    if (!inside(from)) return;
    const auto range = static_cast<float>(m_settings.maxRange);
    std::vector<Eigen::Vector3d> ends;
    for (const Eigen::Vector3f& point : scan.scan->points) {
        const float square = point.squaredNorm();
        if (!(square > 0.01F) || !std::isfinite(square)) continue;
        if (square > range * range) {
            const Eigen::Vector3f cut = point * (range / std::sqrt(square));
            if (inside(scan.scanInMap * cut.cast<double>()))
                ends.push_back(scan.scanInMap * cut.cast<double>());
            continue;
        }
        const Eigen::Vector3d end = scan.scanInMap * point.cast<double>();
        if (!inside(end)) continue;
        const Eigen::Vector3i cube = ((end - low) / m_cell).array().floor().cast<int>();
        if ((cube.array() >= m_size.array()).any()) continue;
        const std::size_t here = index(cube.x(), cube.y(), cube.z());
        if (!marks.hit(here)) continue;  // one ray per cube is enough
        change(here, m_settings.hit);
        ends.push_back(end);
    }
    for (const Eigen::Vector3d& end : ends) castRay(from, end, marks);
}

VoxelEvidence VoxelEvidence::of(std::span<const ReportScan> scans, const EvidenceSettings& settings,
                                const Progress& progress) {
    VoxelEvidence evidence;
    evidence.m_settings = settings;
    const Extent extent = extentOf(scans, settings);
    if (extent.empty()) return evidence;
    evidence.m_cell = settings.cell;
    for (;; evidence.m_cell *= 2) {
        evidence.m_first = (extent.low / evidence.m_cell).array().floor().cast<int>() - 1;
        const Eigen::Vector3i end = (extent.high / evidence.m_cell).array().floor().cast<int>() + 2;
        evidence.m_size = end - evidence.m_first;
        const Eigen::Vector3d size = evidence.m_size.cast<double>();
        if (size.prod() <= static_cast<double>(settings.mostCells)) break;
    }
    const std::size_t cubes = evidence.index(0, evidence.m_size.y(), 0);
    evidence.m_values.assign(cubes, 0);
    Marks marks;
    marks.of.assign(cubes, 0);
    for (std::size_t i = 0; i < scans.size() && !progress.cancelled(); ++i) {
        evidence.add(scans[i], marks);
        progress.done(static_cast<double>(i + 1) / static_cast<double>(scans.size()));
    }
    return evidence;
}

}  // namespace leitstand
