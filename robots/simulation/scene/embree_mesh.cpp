#include "robots/simulation/scene/embree_mesh.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace leitstand::simulation {
namespace {

void check(const Mesh& mesh) {
    const auto fail = [](const char* what) { throw std::invalid_argument(std::string("a mesh: ") + what); };
    if (mesh.surfaceOf.size() != mesh.triangles.size()) fail("expected one surface a triangle");
    if (!mesh.uv.empty() && mesh.uv.size() != mesh.corners.size()) fail("expected one uv a corner, or none");
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            if (corner >= mesh.corners.size()) fail("a triangle names a corner that is not there");
        }
    }
    for (const std::uint16_t surface : mesh.surfaceOf) {
        if (surface >= mesh.surfaces.size()) fail("a triangle names a surface that is not there");
    }
    for (const Surface& surface : mesh.surfaces) {
        if (surface.texture >= static_cast<int>(mesh.textures.size())) {
            fail("a surface names a texture that is not there");
        }
    }
}

}  // namespace

EmbreeMesh::EmbreeMesh(RTCDevice device, Mesh mesh, unsigned maskOfInstance, const IsSolid& isSolid)
    : m_mesh(std::move(mesh)) {
    check(m_mesh);
    for (std::uint32_t i = 0; i < m_mesh.triangles.size(); ++i) {
        m_triangles[isSolid(m_mesh.surfaces[m_mesh.surfaceOf[i]]) ? 0 : 1].push_back(i);
    }
    m_scene = rtcNewScene(device);
    // Rays that graze an edge shared by two triangles must not slip through between them.
    rtcSetSceneFlags(m_scene, RTC_SCENE_FLAG_ROBUST);
    addGeometry(device, 0, mask::Solid);
    addGeometry(device, 1, mask::Soft);
    rtcCommitScene(m_scene);
    m_instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(m_instance, m_scene);
    rtcSetGeometryMask(m_instance, maskOfInstance);
    rtcSetGeometryTimeStepCount(m_instance, 1);
    place(Pose::Identity());
}

EmbreeMesh::~EmbreeMesh() {
    rtcReleaseGeometry(m_instance);
    rtcReleaseScene(m_scene);
}

void EmbreeMesh::addGeometry(RTCDevice device, unsigned id, unsigned maskOfTriangles) {
    const std::vector<std::uint32_t>& triangles = m_triangles[id];
    if (triangles.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto buffer = [&](RTCBufferType type, RTCFormat format, std::size_t stride, std::size_t count) {
        void* memory = rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count);
        if (memory == nullptr) throw std::bad_alloc();
        return memory;
    };
    auto* corners = static_cast<float*>(
        buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3 * sizeof(float), m_mesh.corners.size()));
    for (const Eigen::Vector3f& corner : m_mesh.corners) corners = std::copy_n(corner.data(), 3, corners);
    auto* indices = static_cast<std::uint32_t*>(
        buffer(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    for (const std::uint32_t triangle : triangles) {
        indices = std::copy_n(m_mesh.triangles[triangle].data(), 3, indices);
    }
    rtcSetGeometryMask(geometry, maskOfTriangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(m_scene, geometry, id);
    rtcReleaseGeometry(geometry);
}

void EmbreeMesh::attachTo(RTCScene scene, unsigned id) {
    rtcAttachGeometryByID(scene, m_instance, id);
}

void EmbreeMesh::place(const Pose& meshInArena) {
    m_turn = meshInArena.linear().cast<float>();
    const Eigen::Matrix<float, 3, 4> matrix = meshInArena.matrix().topRows<3>().cast<float>();
    rtcSetGeometryTransform(m_instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix.data());
    rtcEnableGeometry(m_instance);
    rtcCommitGeometry(m_instance);
}

void EmbreeMesh::hide() {
    rtcDisableGeometry(m_instance);
}

Hit EmbreeMesh::hitOf(unsigned geometry, unsigned triangle, float u, float v, const Eigen::Vector3f& normal,
                      const Eigen::Vector3f& direction, float distance) const {
    const std::uint32_t index = m_triangles[geometry][triangle];
    Hit hit;
    hit.distance = distance;
    hit.normal = (m_turn * normal).normalized();
    if (hit.normal.dot(direction) > 0.0F) hit.normal = -hit.normal;
    hit.surface = &m_mesh.surfaces[m_mesh.surfaceOf[index]];
    if (hit.surface->texture >= 0)
        hit.texture = &m_mesh.textures[static_cast<std::size_t>(hit.surface->texture)];
    if (!m_mesh.uv.empty()) {
        const auto& corners = m_mesh.triangles[index];
        hit.uv =
            (1.0F - u - v) * m_mesh.uv[corners[0]] + u * m_mesh.uv[corners[1]] + v * m_mesh.uv[corners[2]];
    }
    return hit;
}

}  // namespace leitstand::simulation
