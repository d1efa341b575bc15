#include "robots/simulation/world/motion/suspension.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "core/base/rotation/heading.h"
#include "robots/simulation/world/motion/feelers.h"
#include "robots/simulation/world/motion/resting_plane.h"

namespace leitstand::simulation {
namespace {

constexpr double Gravity = 9.81;    ///< [m/s2]
constexpr double Lifting = 0.025;   ///< time constant of wheels that climb [s]
constexpr double Yielding = 0.008;  ///< time constant of wheels that follow falling ground [s]
constexpr double Touching = 0.01;   ///< a gap that counts as none [m]
constexpr double Depth = 3.0;       ///< how far down ground is looked for [m]
constexpr double Around = 0.2;      ///< distance of the three places() from base_link's origin [m]

/// Returns three places around base_link's origin, whose heights define a plane's motion [m].
const Eigen::Matrix<double, 3, 2>& places() {
    static const Eigen::Matrix<double, 3, 2> all = [] {
        Eigen::Matrix<double, 3, 2> matrix;
        matrix << Around, 0.0, -0.5 * Around, 0.866 * Around, -0.5 * Around, -0.866 * Around;
        return matrix;
    }();
    return all;
}

}  // namespace

Pose poseOnPlane(const Eigen::Vector3d& position, double yaw, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d up = normal.normalized();
    const double c = std::cos(yaw), s = std::sin(yaw);
    Pose pose = Pose::Identity();
    pose.translation() = position;
    const Eigen::Vector3d ahead = Eigen::Vector3d(c, s, -(up.x() * c + up.y() * s) / up.z()).normalized();
    pose.linear() << ahead, up.cross(ahead), up;
    return pose;
}

Suspension::Suspension(const BodySpec& spec) : m_spec(spec), m_under(spec.contacts) {
    m_under.insert(m_under.end(), spec.belly.begin(), spec.belly.end());
    m_ground.resize(m_under.size());
    m_victims.resize(m_under.size(), -1);
    m_rays.resize(m_under.size());
    m_hits.resize(m_under.size());
    for (Ray& ray : m_rays) ray.direction = {0, 0, -1};
}

void Suspension::feel(const Scene& scene, const Pose& pose) {
    const Eigen::Vector3d up = pose.linear().col(2);
    const Eigen::Vector2d slope = -up.head<2>() / up.z();
    for (std::size_t i = 0; i < m_under.size(); ++i) {
        const Eigen::Vector3d point = pose.linear() * m_under[i];
        const double lift = point.z() - slope.dot(point.head<2>());
        m_ground[i] = {point.x(), point.y(), lift};
        const Eigen::Vector3d from = pose.translation() + point;
        const double above = std::max(0.0, -lift) + m_spec.maxClimb + 0.02;
        m_rays[i].origin = (from + Eigen::Vector3d(0, 0, above)).cast<float>();
        m_rays[i].far = static_cast<float>(above + Depth);
    }
    scene.cast(m_rays, m_hits, RayKind::Contact, Scene::StillOnly);
    for (std::size_t i = 0; i < m_under.size(); ++i) {
        const double start = m_rays[i].origin.z();
        const double found = start - static_cast<double>(m_hits[i].distance);
        const double ground = m_hits[i].there() ? found : std::min(0.0, start - Depth);
        const bool hallFloor = !m_hits[i].there() && start > 0.0;
        m_ground[i].z() = (hallFloor ? 0.0 : ground) - pose.translation().z() - m_ground[i].z();
        const bool victim = m_hits[i].there() && isOfVictim(scene.arena(), *m_hits[i].surface);
        m_victims[i] = victim ? m_hits[i].surface->element : -1;
    }
}

Footing Suspension::step(const Scene& scene, Pose& pose, double seconds) {
    feel(scene, pose);
    Pose next = pose;
    Footing footing = footingOf(pose, seconds, next);
    pose = next;
    return footing;
}

Footing Suspension::settle(const Scene& scene, Pose& pose) {
    Footing footing;
    // The ground under each wheel depends on the tilt, which depends on the ground.
    for (int round = 0; round < 20 && !footing.tips; ++round) {
        footing = step(scene, pose, std::numeric_limits<double>::infinity());
        if (m_resting) break;
    }
    return footing;
}

Footing Suspension::footingOf(const Pose& pose, double seconds, Pose& next) {
    Footing footing;
    const Eigen::Vector3d up = pose.linear().col(2);
    const Eigen::Vector2d weight = (pose.linear() * m_spec.centreOfMass).head<2>();
    const auto plane = restingPlane(m_ground, weight, m_feet);
    if (!plane || up.z() < std::cos(m_spec.maxTilt)) {
        footing.tips = true;
        return footing;
    }
    m_feet = plane->feet;
    const bool atOnce = !std::isfinite(seconds);
    const Eigen::Vector2d slope = -up.head<2>() / up.z();
    Eigen::Vector3d heights;
    double moved = 0.0;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector2d place = places().row(i).transpose();
        const double now = slope.dot(place), gap = now - plane->at(place);
        double& falling = m_falling[static_cast<std::size_t>(i)];
        double change = -gap;
        if (atOnce) {
            falling = 0.0;
        } else if (gap < 0.0) {
            change = -gap * (1.0 - std::exp(-seconds / Lifting));
            falling = 0.0;
        } else {
            const double follows = gap * (1.0 - std::exp(-seconds / Yielding));
            const double drop = std::min(follows, (falling + Gravity * seconds) * seconds);
            falling = drop / seconds;
            change = -drop;
        }
        heights[i] = now + change;
        moved = std::max(moved, std::abs(change));
    }
    m_resting = moved < 1e-6;
    Eigen::Matrix3d system;
    system << Eigen::Vector3d::Ones(), places();
    const Eigen::Vector3d fitted = system.inverse() * heights;
    const Eigen::Vector3d normal(-fitted[1], -fitted[2], 1.0);
    next = poseOnPlane(pose.translation() + Eigen::Vector3d(0, 0, fitted[0]), headingOf(pose), normal);

    for (const Eigen::Vector3d& ground : m_ground) {
        const double gap = fitted[0] + fitted.tail<2>().dot(ground.head<2>()) - ground.z();
        footing.supported = footing.supported || gap < Touching;
    }
    const double load = footing.supported ? m_spec.mass * Gravity * normal.normalized().z() : 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto foot = static_cast<std::size_t>(plane->feet[i]);
        double& side = foot >= m_spec.contacts.size() ? footing.bellyLoad
                       : m_under[foot].y() > 0.0      ? footing.leftLoad
                                                      : footing.rightLoad;
        side += load * plane->shares[i];
        if (plane->shares[i] > 0.02 && m_victims[foot] >= 0) footing.victims.push_back(m_victims[foot]);
    }
    return footing;
}

}  // namespace leitstand::simulation
