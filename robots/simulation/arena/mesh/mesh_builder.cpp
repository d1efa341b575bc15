#include "robots/simulation/arena/mesh/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace leitstand::simulation {
namespace {

constexpr float Level = 0.7071F;  ///< cosine of the steepest floor: 45 degrees, as in LabelSettings

Label labelOf(const Eigen::Vector3f& normal) {
    if (normal.z() > Level) return Label::Floor;
    return normal.z() < -Level ? Label::Ceiling : Label::Wall;
}

/// Returns the right and up axes of a face's texture.
std::pair<Eigen::Vector3d, Eigen::Vector3d> axesOf(const Eigen::Vector3d& normal) {
    const bool level = std::abs(normal.z()) > 0.99;
    const Eigen::Vector3d right = level ? Eigen::Vector3d(Eigen::Vector3d::UnitX())
                                        : Eigen::Vector3d::UnitZ().cross(normal).normalized();
    return {right, normal.cross(right)};
}

}  // namespace

void MeshBuilder::setLook(const Look& look) {
    m_look = look;
    m_surfaces.fill(-1);
}

int MeshBuilder::texture(const std::string& name, const std::function<Texture()>& make) {
    const auto [place, isNew] = m_textures.try_emplace(name, static_cast<int>(m_mesh->textures.size()));
    if (isNew) m_mesh->textures.push_back(make());
    return place->second;
}

std::uint16_t MeshBuilder::surfaceFor(const Eigen::Vector3f& normal) {
    const Label label = m_look.structural ? labelOf(normal) : m_look.surface.label;
    int& index = m_surfaces[static_cast<std::size_t>(label)];
    if (index < 0) {
        index = static_cast<int>(m_mesh->surfaces.size());
        if (index > 0xFFFF) throw std::length_error("a mesh holds at most 65536 surfaces");
        m_mesh->surfaces.push_back(m_look.surface);
        m_mesh->surfaces.back().label = label;
    }
    return static_cast<std::uint16_t>(index);
}

std::uint32_t MeshBuilder::corner(const Eigen::Vector3d& inFrame, const Eigen::Vector2f& uv) {
    m_mesh->corners.emplace_back((m_frame * inFrame).cast<float>());
    m_mesh->uv.push_back(uv);
    return static_cast<std::uint32_t>(m_mesh->corners.size() - 1);
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Eigen::Vector3f& origin = m_mesh->corners[a];
    const Eigen::Vector3f normal = (m_mesh->corners[b] - origin).cross(m_mesh->corners[c] - origin);
    if (!(normal.squaredNorm() > 0.0F)) return;
    m_mesh->triangles.push_back({a, b, c});
    m_mesh->surfaceOf.push_back(surfaceFor(normal.normalized()));
}

void MeshBuilder::face(std::span<const Eigen::Vector3d> corners) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    }
    if (!(normal.norm() > 0.0)) return;
    const auto [right, up] = axesOf(normal.normalized());
    Eigen::AlignedBox2d frame;
    for (const Eigen::Vector3d& one : corners) frame.extend(Eigen::Vector2d(right.dot(one), up.dot(one)));
    const Eigen::Vector2d extent = frame.sizes().cwiseMax(1e-9);
    Eigen::Vector2d scale = extent.cwiseInverse();
    if (m_look.textureSize > 0.0) {
        scale.setConstant(1.0 / std::max(m_look.textureSize, extent.maxCoeff()));
    }
    const Eigen::Vector2d spare = (Eigen::Vector2d::Ones() - extent.cwiseProduct(scale)).cwiseMax(0.0);
    std::vector<std::uint32_t> numbers;
    numbers.reserve(corners.size());
    for (const Eigen::Vector3d& one : corners) {
        const Eigen::Vector2d flat = Eigen::Vector2d(right.dot(one), up.dot(one)) - frame.min();
        const Eigen::Vector2d uv = flat.cwiseProduct(scale) + m_look.textureShift * spare;
        numbers.push_back(corner(one, uv.cwiseMax(0.0).cwiseMin(1.0).cast<float>()));
    }
    for (std::size_t i = 1; i + 1 < numbers.size(); ++i) triangle(numbers[0], numbers[i], numbers[i + 1]);
}

void MeshBuilder::box(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const std::array<Eigen::Vector2d, 4> profile = {
        Eigen::Vector2d(from.x(), from.z()), {to.x(), from.z()}, {to.x(), to.z()}, {from.x(), to.z()}};
    prism(profile, from.y(), to.y());
}

void MeshBuilder::box(const Pose& boxInFrame, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Pose frame = m_frame;
    m_frame = frame * boxInFrame;
    box(from, to);
    m_frame = frame;
}

void MeshBuilder::prism(std::span<const Eigen::Vector2d> profile, double fromY, double toY) {
    const auto at = [&](std::size_t i, double y) {
        const Eigen::Vector2d& point = profile[i % profile.size()];
        return Eigen::Vector3d(point.x(), y, point.y());
    };
    std::vector<Eigen::Vector3d> front;
    std::vector<Eigen::Vector3d> back;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        front.push_back(at(i, fromY));
        back.push_back(at(profile.size() - 1 - i, toY));
        face({at(i, fromY), at(i, toY), at(i + 1, toY), at(i + 1, fromY)});
    }
    face(front);
    face(back);
}

void MeshBuilder::lathe(int rings, int sectors,
                        const std::function<Eigen::Vector3d(int ring, double angle)>& point) {
    std::vector<std::vector<std::uint32_t>> numbers(static_cast<std::size_t>(rings));
    for (int ring = 0; ring < rings; ++ring) {
        const bool pole = ring == 0 || ring == rings - 1;
        for (int i = 0; i <= (pole ? 0 : sectors); ++i) {
            // The last corner stands where the first one does, with the texture's other edge.
            const double angle = 2.0 * std::numbers::pi * (i % sectors) / sectors;
            numbers[static_cast<std::size_t>(ring)].push_back(
                corner(point(ring, angle),
                       Eigen::Vector2f(static_cast<float>(i) / static_cast<float>(sectors),
                                       static_cast<float>(ring) / static_cast<float>(rings - 1))));
        }
    }
    for (std::size_t ring = 0; ring + 1 < numbers.size(); ++ring) {
        const auto& low = numbers[ring];
        const auto& high = numbers[ring + 1];
        for (std::size_t i = 0; i < static_cast<std::size_t>(sectors); ++i) {
            if (low.size() > 1) triangle(low[i], low[i + 1], high.size() > 1 ? high[i + 1] : high[0]);
            if (high.size() > 1) triangle(low.size() > 1 ? low[i] : low[0], high[i + 1], high[i]);
        }
    }
}

void MeshBuilder::ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& radii, int sectors) {
    const int rings = sectors / 2 + 1;
    lathe(rings, sectors, [&](int ring, double angle) -> Eigen::Vector3d {
        const double tilt = std::numbers::pi * ring / (rings - 1);
        const double across = ring == 0 || ring == rings - 1 ? 0.0 : std::sin(tilt);
        return centre + radii.cwiseProduct(Eigen::Vector3d(across * std::cos(angle), across * std::sin(angle),
                                                           -std::cos(tilt)));
    });
}

void MeshBuilder::limb(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusFrom,
                       double radiusTo, int sectors) {
    const Eigen::Vector3d along = (to - from).normalized();
    const Eigen::Vector3d across = along.unitOrthogonal();
    const Eigen::Vector3d third = along.cross(across);
    const int rings = 8;  // four of each ball
    lathe(rings, sectors, [&](int ring, double angle) -> Eigen::Vector3d {
        const bool low = ring < rings / 2;
        const double tilt = std::numbers::pi / 6.0 * (low ? ring : ring - 1);  // 0 to 90, 90 to 180 degrees
        const double radius = low ? radiusFrom : radiusTo;
        const double wide = ring == 0 || ring == rings - 1 ? 0.0 : radius * std::sin(tilt);
        return (low ? from : to) - radius * std::cos(tilt) * along +
               wide * (std::cos(angle) * across + std::sin(angle) * third);
    });
}

void MeshBuilder::cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                           int sectors) {
    const Eigen::Vector3d along = (to - from).normalized();
    const Eigen::Vector3d across = along.unitOrthogonal();
    const Eigen::Vector3d third = along.cross(across);
    lathe(4, sectors, [&](int ring, double angle) -> Eigen::Vector3d {
        const double wide = ring == 0 || ring == 3 ? 0.0 : radius;
        return (ring < 2 ? from : to) + wide * (std::cos(angle) * across + std::sin(angle) * third);
    });
}

void MeshBuilder::sheet(int columns, int rows,
                        const std::function<Eigen::Vector3d(double u, double v)>& point) {
    std::vector<std::uint32_t> numbers;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const double u = static_cast<double>(column) / columns;
            const double v = static_cast<double>(row) / rows;
            numbers.push_back(corner(point(u, v), Eigen::Vector2d(u, v).cast<float>()));
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto at = [&](int dx, int dy) {
                return numbers[static_cast<std::size_t>((row + dy) * (columns + 1) + column + dx)];
            };
            triangle(at(0, 0), at(1, 0), at(1, 1));
            triangle(at(0, 0), at(1, 1), at(0, 1));
        }
    }
}

}  // namespace leitstand::simulation
