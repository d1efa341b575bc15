#include "robots/simulation/scene/scene.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <stdexcept>
#include <utility>
#include <vector>

#include "robots/simulation/scene/embree.h"
#include "robots/simulation/scene/embree_mesh.h"
#include "robots/simulation/scene/smoke.h"

namespace leitstand::simulation {
namespace {

constexpr std::size_t PacketSize = 8;

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

bool castable(const Ray& ray) {
    return ray.origin.allFinite() && ray.direction.allFinite() && ray.direction.squaredNorm() > 0.0F &&
           ray.far > ray.near;
}

}  // namespace

struct Scene::State {
    Arena arena;
    std::vector<MovingPart> parts;  ///< their meshes are in meshes
    std::unique_ptr<RTCDeviceTy, ReleaseDevice> device;
    std::unique_ptr<RTCSceneTy, ReleaseScene> scene;
    std::vector<std::unique_ptr<EmbreeMesh>> meshes;  ///< still mesh, moving parts, bodies, by scene id
    std::vector<std::size_t> bodies;                  ///< their indices in meshes
    std::vector<int> bodyOf;                          ///< of each mesh; -1: none
    Smoke smoke;

    [[nodiscard]] bool stopsRobots(const Surface& surface) const {
        if (propertiesOf(surface.material).solid) return true;
        if (surface.element < 0 || surface.element >= static_cast<int>(arena.elements.size())) return false;
        const ElementKind kind = arena.elements[static_cast<std::size_t>(surface.element)].kind;
        return kind == ElementKind::Victim || kind == ElementKind::Spectator;
    }

    EmbreeMesh& add(Mesh mesh, unsigned maskOfInstance, int body) {
        meshes.push_back(std::make_unique<EmbreeMesh>(device.get(), std::move(mesh), maskOfInstance,
                                                      [this](const Surface& s) { return stopsRobots(s); }));
        bodyOf.push_back(body);
        meshes.back()->attachTo(scene.get(), static_cast<unsigned>(meshes.size() - 1));
        return *meshes.back();
    }
};

Scene::Scene(Arena arena, ArenaMesh mesh) : m_state(std::make_unique<State>()) {
    m_state->arena = std::move(arena);
    m_state->smoke = Smoke(m_state->arena);
    // One thread: a scene is indexed once, and steps of the world are too small to share.
    m_state->device.reset(rtcNewDevice("threads=1"));
    if (!m_state->device) throw std::runtime_error("Embree cannot be started on this processor");
    if (rtcGetDeviceProperty(m_state->device.get(), RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED) == 0) {
        throw std::runtime_error("this build of Embree has no ray masks; expected EMBREE_RAY_MASK=ON");
    }
    m_state->scene.reset(rtcNewScene(m_state->device.get()));
    rtcSetSceneFlags(m_state->scene.get(),
                     static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST));
    rtcSetSceneBuildQuality(m_state->scene.get(), RTC_BUILD_QUALITY_LOW);
    m_state->add(std::move(mesh.still), mask::Still, -1);
    for (MovingPart& part : mesh.moving) {
        m_state->add(std::exchange(part.mesh, {}), mask::Moving, -1);
        m_state->parts.push_back(std::move(part));
    }
    setTime(0.0);
    commit();
}

Scene::~Scene() = default;

int Scene::addBody(const Mesh& mesh) {
    const int body = static_cast<int>(m_state->bodies.size());
    if (body >= MaxBodies) throw std::length_error("a scene holds at most 28 bodies");
    m_state->add(mesh, mask::bodyBit(body), body).hide();
    m_state->bodies.push_back(m_state->meshes.size() - 1);
    return body;
}

void Scene::place(int body, const Pose& bodyInArena) {
    m_state->meshes[m_state->bodies.at(static_cast<std::size_t>(body))]->place(bodyInArena);
}

void Scene::hide(int body) {
    m_state->meshes[m_state->bodies.at(static_cast<std::size_t>(body))]->hide();
}

void Scene::setTime(double seconds) {
    for (std::size_t i = 0; i < m_state->parts.size(); ++i) {
        m_state->meshes[1 + i]->place(m_state->parts[i].at(seconds));
    }
}

void Scene::commit() {
    rtcCommitScene(m_state->scene.get());
}

Hit Scene::cast(const Ray& ray, RayKind kind, int without) const {
    if (!castable(ray)) return {};
    RTCRayHit query = {};
    query.ray.org_x = ray.origin.x();
    query.ray.org_y = ray.origin.y();
    query.ray.org_z = ray.origin.z();
    query.ray.dir_x = ray.direction.x();
    query.ray.dir_y = ray.direction.y();
    query.ray.dir_z = ray.direction.z();
    query.ray.tnear = ray.near;
    query.ray.tfar = ray.far;
    query.ray.mask = mask::of(kind, without);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersect(m_state->scene.get(), query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    if (kind == RayKind::Laser && m_state->smoke.swallows(ray, query.ray.tfar)) return {};
    const std::size_t mesh = query.hit.instID[0];
    Hit hit = m_state->meshes[mesh]->hitOf(query.hit.geomID, query.hit.primID, query.hit.u, query.hit.v,
                                           {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z}, ray.direction,
                                           query.ray.tfar);
    hit.body = m_state->bodyOf[mesh];
    return hit;
}

void Scene::cast(std::span<const Ray> rays, std::span<Hit> hits, RayKind kind, int without) const {
    assert(hits.size() >= rays.size());
    const unsigned allowed = mask::of(kind, without);
    for (std::size_t first = 0; first < rays.size(); first += PacketSize) {
        const std::span<const Ray> packet = rays.subspan(first, std::min(PacketSize, rays.size() - first));
        RTCRayHit8 query = {};
        alignas(32) std::array<int, PacketSize> valid = {};
        for (std::size_t i = 0; i < packet.size(); ++i) {
            const Ray& ray = packet[i];
            valid[i] = castable(ray) ? -1 : 0;
            query.ray.org_x[i] = ray.origin.x();
            query.ray.org_y[i] = ray.origin.y();
            query.ray.org_z[i] = ray.origin.z();
            query.ray.dir_x[i] = ray.direction.x();
            query.ray.dir_y[i] = ray.direction.y();
            query.ray.dir_z[i] = ray.direction.z();
            query.ray.tnear[i] = ray.near;
            query.ray.tfar[i] = ray.far;
            query.ray.mask[i] = allowed;
            query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        intersect(m_state->scene.get(), valid.data(), query);
        for (std::size_t i = 0; i < packet.size(); ++i) {
            Hit& hit = hits[first + i];
            hit = {};
            if (valid[i] == 0 || query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
            if (kind == RayKind::Laser && m_state->smoke.swallows(packet[i], query.ray.tfar[i])) continue;
            const std::size_t mesh = query.hit.instID[0][i];
            hit = m_state->meshes[mesh]->hitOf(query.hit.geomID[i], query.hit.primID[i], query.hit.u[i],
                                               query.hit.v[i],
                                               {query.hit.Ng_x[i], query.hit.Ng_y[i], query.hit.Ng_z[i]},
                                               packet[i].direction, query.ray.tfar[i]);
            hit.body = m_state->bodyOf[mesh];
        }
    }
}

const Arena& Scene::arena() const {
    return m_state->arena;
}

}  // namespace leitstand::simulation
