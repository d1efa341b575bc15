#pragma once

#include <array>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// Look of the shapes that are built next.
struct Look {
    Surface surface;
    bool structural = false;    ///< whether labels depend on the slope: floor, wall, ceiling
    double textureSize = 0.0;   ///< length that the texture covers [m]; 0: the texture fills each face
    double textureShift = 0.0;  ///< where on the texture a face begins, 0 to 1
};

/// Builds closed shapes. All faces are counter-clockwise seen from outside.
class MeshBuilder {
public:
    explicit MeshBuilder(Mesh& mesh) : m_mesh(&mesh) {}

    /// Sets the frame of the shapes that follow.
    void setFrame(const Pose& frame) { m_frame = frame; }
    [[nodiscard]] const Pose& frame() const { return m_frame; }
    void setLook(const Look& look);
    [[nodiscard]] const Look& look() const { return m_look; }
    /// Returns the index of the texture called @p name; calls @p make when it does not exist yet.
    int texture(const std::string& name, const std::function<Texture()>& make);

    /// Adds a flat convex face [m].
    void face(std::span<const Eigen::Vector3d> corners);
    void face(std::initializer_list<Eigen::Vector3d> corners) {
        face(std::span(corners.begin(), corners.size()));
    }
    /// Adds a box from corner @p from to corner @p to [m].
    void box(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
    /// Adds a box from corner @p from to corner @p to [m], in a frame at @p boxInFrame.
    void box(const Pose& boxInFrame, const Eigen::Vector3d& from, const Eigen::Vector3d& to);
    /// Extrudes the convex polygon @p profile along y, from @p fromY to @p toY [m]. Its points are x and z,
    /// counter-clockwise seen from -y.
    void prism(std::span<const Eigen::Vector2d> profile, double fromY, double toY);
    void ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& radii, int sectors = 14);
    /// Adds a limb: two balls and the cone between them [m].
    void limb(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusFrom, double radiusTo,
              int sectors = 10);
    /// Adds a cylinder with flat ends [m].
    void cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, int sectors = 14);
    /// Adds a curved sheet through point(u, v), with u and v from 0 to 1. The texture fills the sheet.
    void sheet(int columns, int rows, const std::function<Eigen::Vector3d(double u, double v)>& point);

private:
    std::uint32_t corner(const Eigen::Vector3d& inFrame, const Eigen::Vector2f& uv);
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    /// Connects rings of corners to a surface. The first and the last ring are single points.
    void lathe(int rings, int sectors, const std::function<Eigen::Vector3d(int ring, double angle)>& point);
    std::uint16_t surfaceFor(const Eigen::Vector3f& normal);

    Mesh* m_mesh;
    Pose m_frame = Pose::Identity();
    Look m_look;
    /// Surface of the present look for each label; -1: not made yet.
    std::array<int, LabelCount> m_surfaces = {-1, -1, -1, -1};
    std::map<std::string, int> m_textures;
};

}  // namespace leitstand::simulation
