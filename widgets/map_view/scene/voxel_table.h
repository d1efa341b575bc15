#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand {

/// The data of one occupied voxel.
struct Voxel {
    std::uint64_t key = 0;
    std::array<std::uint32_t, LabelCount> labels{};  ///< number of points per label
    float valueSum = 0.0F;                           ///< sum of ranges [m] or of shades
    std::uint32_t points = 0;                        ///< 0: a free slot of the table
    bool certain = false;                            ///< whether a point of a certain scan is in it
    std::uint32_t scan = 0, votes = 0;  ///< source with most points (Boyer and Moore's majority vote)

    [[nodiscard]] Label majority() const;
};

/// A hash table of occupied voxels by cell, made for millions of points.
class VoxelTable {
public:
    /// @p size: edge of a voxel [m].
    explicit VoxelTable(double size);

    void add(const Eigen::Vector3f& pointInMap, Label label, float value, std::uint32_t scan,
             bool certain = true);
    [[nodiscard]] bool occupied(const Eigen::Array3i& cell) const;
    [[nodiscard]] std::size_t size() const { return m_used; }

    /// Calls @p visit(cell, voxel) for each occupied voxel.
    template <class Visit>
    void forEach(Visit visit) const {
        for (const Voxel& voxel : m_slots) {
            if (voxel.points > 0) visit(cellOf(voxel.key), voxel);
        }
    }

private:
    [[nodiscard]] static std::uint64_t keyOf(const Eigen::Array3i& cell);
    [[nodiscard]] static Eigen::Array3i cellOf(std::uint64_t key);
    [[nodiscard]] std::size_t slotOf(std::uint64_t key) const;
    void grow();

    float m_cellsPerMetre;
    std::vector<Voxel> m_slots;  ///< the size is a power of two; at most half of it is used
    std::size_t m_used = 0;
};

}  // namespace leitstand
