#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/mapping/report_scan.h"

namespace leitstand {

/// How rays become evidence. Evidence is 35 times the natural logarithm of the odds, which fits into a byte.
/// The odds are those of OctoMap (Hornung et al. 2013, table 1).
struct EvidenceSettings {
    double cell = 0.05;      ///< edge of a cube [m]; doubled until the map has at most mostCells
    double maxRange = 12.0;  ///< longer rays end here and are treated as having no echo [m]
    /// Log odds of 0.85 and -0.4; limits of a cube are -2 and 3.5.
    int hit = 30, miss = -14, least = -70, most = 123;
    std::size_t mostCells = 96'000'000;
    /// Largest size along each axis, around the scans [m]; points outside are left out.
    double mostExtent = 400.0;
};

/// Evidence for the cubes of a map: above 0 occupied, below 0 free, 0 never seen. Each scan adds to a cube
/// once: as a hit if one of its echoes is in the cube, otherwise as a miss if a ray passes through.
class VoxelEvidence {
public:
    /// Computes the evidence of @p scans, in their order. Empty when no scan has a point.
    [[nodiscard]] static VoxelEvidence of(std::span<const ReportScan> scans,
                                          const EvidenceSettings& settings = {},
                                          const Progress& progress = {});

    [[nodiscard]] double cell() const { return m_cell; }                  ///< edge of a cube [m]
    [[nodiscard]] const Eigen::Vector3i& size() const { return m_size; }  ///< number of cubes along x, y, z
    /// Returns the indices of the first cube along x, y, z. Its lowest corner is at first() * cell() in the
    /// map [m].
    [[nodiscard]] const Eigen::Vector3i& first() const { return m_first; }
    [[nodiscard]] Eigen::Vector3d origin() const { return m_first.cast<double>() * m_cell; }
    [[nodiscard]] bool empty() const { return m_values.empty(); }

    /// Returns the evidence of the cube with these indices, counted from first(); 0 outside the map.
    [[nodiscard]] int at(int x, int y, int z) const {
        if (x < 0 || y < 0 || z < 0 || x >= m_size.x() || y >= m_size.y() || z >= m_size.z()) return 0;
        return m_values[index(x, y, z)];
    }
    [[nodiscard]] const EvidenceSettings& settings() const { return m_settings; }

private:
    struct Marks;
    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.x()) +
                static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(m_size.z()) +
               static_cast<std::size_t>(z);
    }
    void change(std::size_t cube, int by);
    void add(const ReportScan& scan, Marks& marks);
    void castRay(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Marks& marks);

    EvidenceSettings m_settings;
    double m_cell = 0.05;
    Eigen::Vector3i m_first = Eigen::Vector3i::Zero(), m_size = Eigen::Vector3i::Zero();
    std::vector<std::int8_t> m_values;
};

}  // namespace leitstand
