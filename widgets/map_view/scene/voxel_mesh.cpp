#include "widgets/map_view/scene/voxel_mesh.h"

#include <array>
#include <cstdint>
#include <limits>

#include "widgets/map_view/scene/voxel_table.h"

namespace leitstand {
namespace {

/// One side of a cube: outward direction and two axes along it, u x v = outward.
struct Side {
    Eigen::Array3i outward, u, v;
    double light;  ///< brightness under a sun from above, behind and right of the first scan
};

const std::array<Side, 6>& sides() {
    static const std::array<Side, 6> all = {{
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 1.00},
        {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, 0.50},
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.62},
        {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0.84},
        {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 0.68},
        {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}, 0.76},
    }};
    return all;
}

/// Share of light that reaches a corner with 0 to 3 occupied cubes around it.
constexpr std::array<double, 4> CornerLight = {1.0, 0.86, 0.74, 0.62};

/// Returns a brightness that varies slightly by cell, so that cubes of one colour in one plane can be
/// counted.
double grain(const Eigen::Array3i& cell) {
    const auto at = [&cell](int axis) { return static_cast<std::uint32_t>(cell[axis]); };
    std::uint32_t hash = (at(0) * 73'856'093U) ^ (at(1) * 19'349'663U);
    hash = (hash ^ (at(2) * 83'492'791U)) * 2'654'435'761U;
    return 0.94 + 0.06 * static_cast<double>(hash >> 16U) / 65'535.0;
}

Rgba plainColourOf(const Voxel& voxel, double height, const VoxelRecipe& recipe) {
    const auto onRamp = [&recipe](double value) {
        return viridis((value - recipe.ramp.low) / (recipe.ramp.high - recipe.ramp.low));
    };
    switch (recipe.colouring) {
        case MapColouring::Label:
            return labelColour(voxel.majority());
        case MapColouring::Scan:
        case MapColouring::Robot:
        case MapColouring::Age:
            return recipe.sources[voxel.scan].colour;
        case MapColouring::Height:
            return onRamp(height);
        case MapColouring::Range:
        case MapColouring::Intensity:
            return onRamp(voxel.valueSum / static_cast<float>(voxel.points));
    }
    return {};
}

Rgba colourOf(const Voxel& voxel, double height, const VoxelRecipe& recipe) {
    const MapColours& colours = mapColours(recipe.theme);
    if (!voxel.certain && recipe.inQuestion == recipe.sources[voxel.scan].scan) return colours.scanInQuestion;
    const Rgba plain = voxel.certain ? plainColourOf(voxel, height, recipe) : colours.uncertainScan;
    return recipe.inQuestion || recipe.changes ? dimmed(plain, recipe.theme) : plain;
}

/// Returns the voxels that hold @p points (map's frame); none when null.
VoxelTable voxelsOf(const ScanPointsPtr& points, double size) {
    VoxelTable table(size);
    if (!points) return table;
    for (const Eigen::Vector3f& point : points->points) table.add(point, Label::Unlabelled, 0.0F, 0);
    return table;
}

/// Adds the points of @p source to @p table; false when interrupted. @p number: index of the source in the
/// recipe.
bool fill(VoxelTable& table, const VoxelSource& source, std::uint32_t number, const VoxelRecipe& recipe,
          const std::function<bool()>& interrupted) {
    constexpr std::size_t PointsBetweenLooks = 1U << 16U;
    const Eigen::Matrix4f pose = source.poseInMap.cast<float>();
    const Eigen::Matrix3f rotation = pose.topLeftCorner<3, 3>();
    const Eigen::Vector3f translation = pose.topRightCorner<3, 1>();
    const auto low = static_cast<float>(recipe.minHeight.value_or(-std::numeric_limits<float>::max()));
    const auto high = static_cast<float>(recipe.maxHeight.value_or(std::numeric_limits<float>::max()));
    for (std::size_t i = 0; i < source.points->points.size(); ++i) {
        if (i % PointsBetweenLooks == 0 && interrupted()) return false;
        const Eigen::Vector3f& inScan = source.points->sample(i);
        const Eigen::Vector3f inMap = rotation * inScan + translation;
        if (inMap.z() < low || inMap.z() > high) continue;
        const Label label = source.points->labelOfSample(i);
        if (!recipe.withCeiling && label == Label::Ceiling) continue;
        const float value =
            recipe.colouring == MapColouring::Intensity ? source.points->shadeOfSample(i) : inScan.norm();
        table.add(inMap, label, value, number, !source.uncertain);
    }
    return true;
}

/// Writes the faces of cubes into the mesh, except those that neighbours hide.
class MeshWriter {
public:
    MeshWriter(const VoxelTable& table, double size, VoxelMesh& mesh)
        : m_table(table), m_size(static_cast<float>(size)), m_mesh(mesh) {}

    void addCube(const Eigen::Array3i& cell, Rgba colour) {
        for (const Side& side : sides()) {
            if (!m_table.occupied(cell + side.outward)) addFace(cell, side, colour);
        }
    }

private:
    void addFace(const Eigen::Array3i& cell, const Side& side, Rgba colour) {
        static constexpr std::array<std::array<int, 2>, 4> Corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
        const auto first = static_cast<std::int32_t>(m_mesh.vertices.size());
        const double light = side.light * grain(cell);
        std::array<int, 4> neighbours{};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto [u, v] = Corners[i];
            const Eigen::Array3i corner = 2 * cell + 1 + side.outward + u * side.u + v * side.v;
            m_mesh.vertices.push_back((0.5F * m_size * corner.cast<float>()).matrix());
            neighbours[i] = neighboursAt(cell + side.outward, u * side.u, v * side.v);
            m_mesh.colours.push_back(
                shaded(colour, light * CornerLight[static_cast<std::size_t>(neighbours[i])]));
        }
        // Split along the brighter diagonal; otherwise the shade of a corner runs across the face.
        const bool turned = neighbours[0] + neighbours[2] > neighbours[1] + neighbours[3];
        for (const int offset : turned ? std::array{1, 2, 3, 1, 3, 0} : std::array{0, 1, 2, 0, 2, 3}) {
            m_mesh.triangles.push_back(first + offset);
        }
    }

    [[nodiscard]] int neighboursAt(const Eigen::Array3i& front, const Eigen::Array3i& u,
                                   const Eigen::Array3i& v) const {
        const bool besideU = m_table.occupied(front + u), besideV = m_table.occupied(front + v);
        if (besideU && besideV) return 3;
        return static_cast<int>(besideU) + static_cast<int>(besideV) +
               static_cast<int>(m_table.occupied(front + u + v));
    }

    const VoxelTable& m_table;
    float m_size;
    VoxelMesh& m_mesh;
};

}  // namespace

std::optional<VoxelMesh> buildVoxels(const VoxelRecipe& recipe, const std::function<bool()>& interrupted) {
    VoxelTable table(recipe.size);
    for (std::size_t i = 0; i < recipe.sources.size(); ++i) {
        const auto number = static_cast<std::uint32_t>(i);
        if (!fill(table, recipe.sources[i], number, recipe, interrupted)) return std::nullopt;
    }
    const VoxelTable came = voxelsOf(recipe.came, recipe.size), went = voxelsOf(recipe.went, recipe.size);
    VoxelMesh mesh;
    MeshWriter writer(table, recipe.size, mesh);
    table.forEach([&](const Eigen::Array3i& cell, const Voxel& voxel) {
        const MapColours& colours = mapColours(recipe.theme);
        writer.addCube(cell, came.occupied(cell)   ? colours.newThing
                             : went.occupied(cell) ? colours.goneThing
                                                   : colourOf(voxel, (cell.z() + 0.5) * recipe.size, recipe));
    });
    mesh.voxels = table.size();
    return mesh;
}

}  // namespace leitstand
