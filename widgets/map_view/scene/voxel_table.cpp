#include "widgets/map_view/scene/voxel_table.h"

#include <algorithm>

namespace leitstand {
namespace {

constexpr int AxisBits = 21;
constexpr int AxisOffset = 1 << (AxisBits - 1);
constexpr std::uint64_t AxisMask = (std::uint64_t{1} << AxisBits) - 1;

}  // namespace

Label Voxel::majority() const {
    const auto most = std::max_element(labels.begin() + 1, labels.end());
    if (*most == 0) return Label::Unlabelled;  // any label, however rare, wins over none
    return static_cast<Label>(most - labels.begin());
}

VoxelTable::VoxelTable(double size) : m_cellsPerMetre(static_cast<float>(1.0 / size)), m_slots(1U << 14) {}

void VoxelTable::add(const Eigen::Vector3f& pointInMap, Label label, float value, std::uint32_t scan,
                     bool certain) {
    const Eigen::Array3i cell = (pointInMap.array() * m_cellsPerMetre).floor().cast<int>();
    const std::uint64_t key = keyOf(cell);
    Voxel* voxel = &m_slots[slotOf(key)];
    if (voxel->points == 0) {
        if (2 * (m_used + 1) > m_slots.size()) {
            grow();
            voxel = &m_slots[slotOf(key)];
        }
        voxel->key = key;
        ++m_used;
    }
    ++voxel->points;
    voxel->certain = voxel->certain || certain;
    ++voxel->labels[static_cast<std::size_t>(label)];
    voxel->valueSum += value;
    if (voxel->votes == 0) voxel->scan = scan;
    if (voxel->scan == scan) {
        ++voxel->votes;
    } else {
        --voxel->votes;
    }
}

bool VoxelTable::occupied(const Eigen::Array3i& cell) const {
    return m_slots[slotOf(keyOf(cell))].points > 0;
}

std::uint64_t VoxelTable::keyOf(const Eigen::Array3i& cell) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
        key = (key << AxisBits) | (static_cast<std::uint64_t>(cell[axis] + AxisOffset) & AxisMask);
    }
    return key;
}

Eigen::Array3i VoxelTable::cellOf(std::uint64_t key) {
    const auto axis = [key](int shift) { return static_cast<int>((key >> shift) & AxisMask) - AxisOffset; };
    return {axis(2 * AxisBits), axis(AxisBits), axis(0)};
}

std::size_t VoxelTable::slotOf(std::uint64_t key) const {
    const std::size_t mask = m_slots.size() - 1;
    std::uint64_t hash = key * 0x9E3779B97F4A7C15ULL;  // Fibonacci hashing: the high bits are well mixed
    std::size_t slot = static_cast<std::size_t>(hash >> 32) & mask;
    while (m_slots[slot].points > 0 && m_slots[slot].key != key) slot = (slot + 1) & mask;
    return slot;
}

void VoxelTable::grow() {
    std::vector<Voxel> former(2 * m_slots.size());
    former.swap(m_slots);
    for (const Voxel& voxel : former) {
        if (voxel.points > 0) m_slots[slotOf(voxel.key)] = voxel;
    }
}

}  // namespace leitstand
