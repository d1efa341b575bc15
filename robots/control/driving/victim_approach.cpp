#include "robots/control/driving/victim_approach.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/perception/cues/body_heat.h"
#include "core/robot/robot_says.h"

namespace leitstand {
namespace {

constexpr double Pi = std::numbers::pi;
constexpr double InSight = 0.5;   // cues so young show it now [s]
constexpr double Deepest = 0.4;   // of a victim, before and behind what is seen in its middle [m]
constexpr double Beside = 0.12;   // of the heat: walls go on there [rad]
constexpr double Blurred = 0.15;  // heights of heat are as sure as that [m]
constexpr double Farthest = 9.0;  // surfaces beyond are not those of a victim that was seen [m]

double secondsBetween(Time from, Time to) {
    return std::chrono::duration<double>(to - from).count();
}

/// As robots say lengths.
std::string metres(double length) {
    return fmt::format("{:.2f}", length);
}

Eigen::Isometry2d flat(const Pose& pose) {
    const Eigen::Vector3d ahead = pose.linear().col(0);
    Eigen::Isometry2d result = Eigen::Isometry2d::Identity();
    result.rotate(std::atan2(ahead.y(), ahead.x()));
    result.pretranslate(Eigen::Vector2d(pose.translation().head<2>()));
    return result;
}

/// Distance of @p point from the front edge of @p body [m].
double fromFront(const BodyBox& body, const Eigen::Vector2d& point) {
    const double beside = std::max({0.0, point.y() - body.left, -body.right - point.y()});
    return std::hypot(point.x() - body.front, beside) * (point.x() < body.front ? -1.0 : 1.0);
}

ExplorerSettings detourSettings(const VictimApproachSettings& settings) {
    ExplorerSettings detour;
    detour.lookFirst = 0.0;
    detour.goalNear = settings.distance + 0.2;
    return detour;
}

/// Direction of a cue in base_link [rad].
double bearingOf(const HeatCue& cue, const Pose& baseInOdom) {
    const Eigen::Vector2d towards = flat(baseInOdom).linear().transpose() * cue.ray.direction.head<2>();
    return std::atan2(towards.y(), towards.x());
}

}  // namespace

std::vector<HeatCue> cuesFrom(const std::vector<HeatBlob>& blobs, const ThermalPicture& picture,
                              const CameraInfoSample& camera, const Pose& opticalInOdom, Time at) {
    std::vector<HeatCue> cues;
    for (const HeatBlob& blob : blobs) {
        if (blob.kind != HeatBlob::Kind::Body) continue;
        const auto direction = pixelDirection(camera, blob.centre, picture.width, picture.height);
        if (!direction) continue;
        cues.push_back({at, rayFrom(opticalInOdom, *direction), blob.width, blob.mean, blob.confidence,
                        blob.size, blob.cut, judgeBody(picture, blob, 1.0).clothes});
    }
    return cues;
}

VictimApproach::VictimApproach(FuzzyDrive drive, const VictimApproachSettings& settings)
    : m_drive(std::move(drive)), m_settings(settings), m_around(m_drive, detourSettings(settings)) {}

void VictimApproach::start(const HeatCue& cue, Time now) {
    m_phase = Phase::Turn;
    m_started = m_since = now;
    m_cue = cue;
    m_cueAt = now;
    m_corrections = 0;
    m_place.reset();
    m_begun.reset();
    m_detour = false;
}

double VictimApproach::bearing(const Pose& baseInOdom) const {
    if (!m_place) return bearingOf(m_cue, baseInOdom);
    const Eigen::Vector2d towards = flat(baseInOdom).inverse() * *m_place;
    return std::atan2(towards.y(), towards.x());
}

void VictimApproach::abort() {
    m_phase = Phase::Idle;
}

std::optional<HeatCue> VictimApproach::pick(const std::vector<HeatCue>& cues, const VirtualScanView& view,
                                            const Pose& baseInOdom) const {
    if (isActive()) {
        const auto nearest = std::max_element(cues.begin(), cues.end(), [&](const auto& a, const auto& b) {
            return a.ray.direction.dot(m_cue.ray.direction) < b.ray.direction.dot(m_cue.ray.direction);
        });
        return nearest == cues.end() ? std::nullopt : std::optional<HeatCue>(*nearest);
    }
    const auto first = std::find_if(cues.begin(), cues.end(),
                                    [&](const HeatCue& cue) { return isNew(cue, view, baseInOdom); });
    return first == cues.end() ? std::nullopt : std::optional<HeatCue>(*first);
}

double VictimApproach::heightAt(const HeatCue& cue, const Eigen::Vector2d& place, const Pose& baseInOdom) {
    const double run = std::max(0.05, cue.ray.direction.head<2>().norm());
    const double away = (place - cue.ray.origin.head<2>()).norm();
    return cue.ray.origin.z() + cue.ray.direction.z() / run * away - baseInOdom.translation().z();
}

void VictimApproach::take(const HeatCue& cue) {
    if (cue.at <= m_cue.at || !cue.ray.direction.allFinite()) return;
    // Another body does not draw it away from the one that it drives to.
    const double off =
        std::acos(std::clamp(cue.ray.direction.normalized().dot(m_cue.ray.direction), -1.0, 1.0));
    if (off > 0.6) return;
    m_cue = cue;
}

std::vector<VictimApproach::Target> VictimApproach::wholeVictim(std::vector<Target> heat,
                                                                const VirtualScanView& view) const {
    std::erase_if(heat, [&](const Target& one) {
        return one.top > m_settings.lying && std::any_of(heat.begin(), heat.end(), [&](const Target& other) {
                   return other.top <= m_settings.lying;
               });
    });
    if (heat.empty() || heat.front().top > m_settings.lying) return heat;
    std::vector<Target> rest;
    for (const VirtualObstacle& one : view.obstacles) {
        const bool near = std::any_of(heat.begin(), heat.end(), [&](const Target& other) {
            return (other.inBase - one.where).norm() < m_settings.length;
        });
        if (one.top > m_settings.lying || !near) continue;
        rest.push_back({one.where, fromFront(m_drive.settings().safety.body, one.where), one.age, one.top});
    }
    for (std::size_t i = 0; i < heat.size(); ++i) {
        const Eigen::Vector2d here = heat[i].inBase;
        const auto linked = std::stable_partition(rest.begin(), rest.end(), [&](const Target& one) {
            return (one.inBase - here).norm() > m_settings.link;
        });
        heat.insert(heat.end(), linked, rest.end());
        rest.erase(linked, rest.end());
    }
    return heat;
}

std::optional<VictimApproach::Target> VictimApproach::target(const HeatCue& cue, const VirtualScanView& view,
                                                             const Pose& baseInOdom) const {
    const Eigen::Isometry2d toBase = flat(baseInOdom).inverse();
    const Eigen::Vector2d origin = toBase * Eigen::Vector2d(cue.ray.origin.head<2>());
    const Eigen::Vector2d towards = (toBase.linear() * cue.ray.direction.head<2>()).normalized();
    const double band = 0.5 * cue.width + m_settings.bandMargin;
    struct Seen {
        Target target;
        double off, range;  ///< off: left positive [rad]
        bool lies;          ///< low, and the heat is at its height
    };
    std::vector<Seen> seen;
    for (const VirtualObstacle& one : view.obstacles) {
        const Eigen::Vector2d away = one.where - origin;
        const double off = std::atan2(towards.x() * away.y() - towards.y() * away.x(), towards.dot(away));
        if (std::abs(off) > band + Beside || away.norm() > Farthest) continue;
        const double distance = fromFront(m_drive.settings().safety.body, one.where);
        const double height = heightAt(cue, flat(baseInOdom) * one.where, baseInOdom);
        const bool lies = one.top <= m_settings.lying && height > -Blurred && height < one.top + Blurred;
        seen.push_back({{one.where, distance, one.age, one.top}, off, away.norm(), lies});
    }
    if (seen.empty()) return std::nullopt;
    // Past the edge of a wall: the heat is on what lies behind.
    const auto inBand = [band](const Seen& one) { return std::abs(one.off) <= band; };
    const auto lying =
        std::count_if(seen.begin(), seen.end(), [&](const Seen& one) { return one.lies && inBand(one); });
    if (lying > 1) std::erase_if(seen, [](const Seen& one) { return !one.lies; });
    // What the middle of the heat is on; what else is in the band may stand before or behind it.
    const double range = std::min_element(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
                             return std::abs(a.off) < std::abs(b.off);
                         })->range;
    std::vector<Target> found;
    bool left = false, right = false, beyond = false;
    for (const Seen& one : seen) {
        if (std::abs(one.range - range) > Deepest) continue;
        if (!inBand(one)) {
            beyond = true;
            continue;
        }
        found.push_back(one.target);
        left = left || one.off >= 0.0;
        right = right || one.off <= 0.0;
    }
    if (found.empty()) return std::nullopt;
    found = wholeVictim(std::move(found), view);
    std::sort(found.begin(), found.end(),
              [](const Target& a, const Target& b) { return a.distance < b.distance; });
    // The second nearest of one surface: a single point is too near by its noise.
    const bool second = found.size() > 3 && found[1].distance < found[0].distance + 0.05;
    Target nearest = found[second ? 1 : 0];
    nearest.certain = (left && right) || !beyond;
    for (const Target& one : found) {
        if (one.distance < nearest.distance + 0.15) nearest.age = std::max(nearest.age, one.age);
    }
    return nearest;
}

bool VictimApproach::isNew(const HeatCue& cue, const VirtualScanView& view, const Pose& baseInOdom) const {
    const auto surface = target(cue, view, baseInOdom);
    if (!surface || !surface->certain) return false;
    const Eigen::Vector2d place = flat(baseInOdom) * surface->inBase;
    if (heightAt(cue, place, baseInOdom) > m_settings.highest) return false;
    const auto there = [&](const auto& other) { return (other - place).norm() < m_settings.sameVictim; };
    if (isKnown(place) || std::any_of(m_givenUp.begin(), m_givenUp.end(), there)) return false;
    const auto glimpses = std::count_if(m_hidden.begin(), m_hidden.end(), there);
    return glimpses == 0 || (glimpses < m_settings.tries && seenOf(cue, place) > 2.0 * m_settings.glimpse);
}

double VictimApproach::seenOf(const HeatCue& cue, const Eigen::Vector2d& place) {
    return cue.size * (place - cue.ray.origin.head<2>()).norm();
}

double VictimApproach::clothesOf(const HeatCue& cue, const Eigen::Vector2d& place) {
    return cue.clothes * (place - cue.ray.origin.head<2>()).squaredNorm();
}

bool VictimApproach::isKnown(const Eigen::Vector2d& place) const {
    return std::any_of(m_sightings.begin(), m_sightings.end(), [&](const Sighting& one) {
        return (one.position.head<2>() - place).norm() < m_settings.sameVictim;
    });
}

ApproachStep VictimApproach::giveUp(const std::string& reason, const Eigen::Vector2d& place) {
    m_givenUp.push_back(place);
    if (m_begun) m_givenUp.push_back(*m_begun);
    return leave(reason);
}

ApproachStep VictimApproach::leave(const std::string& reason) {
    m_phase = Phase::Idle;
    ApproachStep step;
    step.failed = true;
    step.reason = reason;
    return step;
}

ApproachStep VictimApproach::reach(const Target& target, const Pose& baseInOdom) {
    m_phase = Phase::Reached;
    Sighting sighting;
    sighting.id = static_cast<std::uint32_t>(m_sightings.size() + 1);
    sighting.kind = "victim";
    const Eigen::Vector2d place = flat(baseInOdom) * target.inBase;
    const double height = std::clamp(heightAt(m_cue, place, baseInOdom), 0.0, m_settings.highest);
    sighting.position = {place.x(), place.y(), baseInOdom.translation().z() + height};
    sighting.deviation = 0.15;
    sighting.confidence = m_cue.confidence;
    sighting.value = m_cue.temperature;
    sighting.text = fmt::format(robot_says::BodyHeat, fmt::format("{:.1f}", m_cue.temperature));
    m_sightings.push_back(sighting);
    ApproachStep step;
    step.done = true;
    step.distance = target.distance;
    step.reason = fmt::format(robot_says::BeforeAVictim, metres(target.distance));
    return step;
}

bool VictimApproach::isBehindSomething(const std::optional<Target>& target, double bearing,
                                       const VirtualScanView& view) const {
    const SafeTeleoperationSettings& safety = m_drive.settings().safety;
    const BodyBox body = safety.body.grown(safety.margin);
    const double away = target ? target->inBase.norm() : 3.0;
    return target && target->distance > m_settings.distance + 0.1 &&
           view.freeLength(bearing, body.left + body.right, away) < away - 0.4;
}

ApproachStep VictimApproach::goAround(const Eigen::Vector2d& place, const VirtualScanView& view,
                                      const Pose& baseInOdom, Time now) {
    double age = 60.0;
    for (const VirtualSector& sector : view.sectors) age = std::min(age, sector.age);
    m_around.setGoal(place);
    const ExplorerStep around =
        m_around.step(view, baseInOdom, now - std::chrono::nanoseconds(std::llround(age * 1e9)), now);
    ApproachStep step;
    step.velocity = around.velocity;
    step.reason = robot_says::DrivesAround;
    return step;
}

DriveVelocity VictimApproach::towards(const std::optional<Target>& target, double bearing,
                                      const VirtualScanView& view, std::string& reason) const {
    const FuzzyDriveSettings& drive = m_drive.settings();
    const double turn = std::clamp(1.5 * bearing, -m_settings.turnRate, m_settings.turnRate);
    const double error = target ? target->distance - m_settings.distance : 1.0;
    double forward = 0.0;
    if (std::abs(bearing) < 0.35) {
        const double share = std::clamp(std::abs(error) / m_settings.slowFrom, 0.12, 1.0);
        forward = std::copysign(m_settings.speed * share, error);
        if (std::abs(error) < 0.2 * m_settings.tolerance) forward = 0.0;
    }
    const SafeVelocity safe = safeVelocity({forward, 0.0, turn}, view, drive.safety);
    reason = target ? fmt::format(robot_says::HeatAhead, metres(target->distance)) : robot_says::DrivesToHeat;
    if (!safe.reason.empty()) reason += "; " + safe.reason;
    return safe.velocity;
}

ApproachStep VictimApproach::step(const std::optional<HeatCue>& cue, const VirtualScanView& view,
                                  const Pose& baseInOdom, Time now) {
    ApproachStep step;
    if (m_phase == Phase::Idle) {
        step.failed = true;
        step.reason = robot_says::NoHeat;
        return step;
    }
    if (cue && cue->at > m_cue.at) {
        const Time before = m_cue.at;
        take(*cue);
        if (m_cue.at > before) m_cueAt = now;
    }
    m_around.see(view, baseInOdom, now);
    const bool inSight = secondsBetween(m_cueAt, now) < InSight;
    const auto surface = target(m_cue, view, baseInOdom);
    if (surface && inSight) m_place = flat(baseInOdom) * surface->inBase;
    if (surface && !m_begun) m_begun = flat(baseInOdom) * surface->inBase;
    if (surface) step.distance = surface->distance;
    if (m_phase == Phase::Reached) {
        step.done = true;
        step.reason = robot_says::AtAVictim;
        return step;
    }
    const double direction = bearingOf(m_cue, baseInOdom);
    const Eigen::Vector2d ahead =
        surface ? surface->inBase : Eigen::Vector2d(2.0 * std::cos(direction), 2.0 * std::sin(direction));
    const Eigen::Vector2d place = flat(baseInOdom) * ahead;
    // Near the end a victim on the floor may be out of the camera's sight.
    const bool close = surface && surface->distance < m_settings.distance + 0.5;
    if (secondsBetween(m_cueAt, now) > m_settings.lostAfter * (close || m_detour ? 3.0 : 1.0))
        return giveUp(robot_says::HeatLost, place);
    if (secondsBetween(m_started, now) > m_settings.giveUpAfter)
        return giveUp(robot_says::HeatUnreachable, place);

    const double bearing = std::atan2(ahead.y(), ahead.x());
    const double error = surface ? surface->distance - m_settings.distance : 1.0;
    switch (m_phase) {
        case Phase::Idle:
        case Phase::Reached:
            break;
        case Phase::Turn:
            step.reason = robot_says::TurnsToHeat;
            if (std::abs(bearing) < 0.15) {
                m_phase = Phase::Approach;
                break;
            }
            step.velocity = safeVelocity({0.0, 0.0, std::copysign(m_settings.turnRate, bearing)}, view,
                                         m_drive.settings().safety)
                                .velocity;
            if (isZero(step.velocity)) m_phase = Phase::Approach;
            break;
        case Phase::Approach:
            if (surface && std::abs(error) < 0.3 * m_settings.tolerance && std::abs(bearing) < 0.3) {
                m_phase = Phase::Settle;
                m_since = now;
                step.reason = robot_says::MeasuresAgain;
                break;
            }
            // What is out of sight on a detour is still where it was.
            m_detour = (m_detour && !inSight) || isBehindSomething(surface, bearing, view);
            if (m_detour) {
                step = goAround(m_place.value_or(place), view, baseInOdom, now);
                if (surface) step.distance = surface->distance;
                break;
            }
            if (std::abs(bearing) > 0.8) m_phase = Phase::Turn;
            step.velocity = towards(surface, bearing, view, step.reason);
            break;
        case Phase::Settle:
            step.reason = robot_says::MeasuresAgain;
            if (secondsBetween(m_since, now) < m_settings.settle) break;
            if (surface && isKnown(place)) return giveUp(robot_says::VictimKnown, place);
            if (surface && inSight && !m_cue.cut && seenOf(m_cue, place) < m_settings.glimpse) {
                m_hidden.push_back(place);
                return leave(robot_says::HeatHidden);
            }
            if (surface && inSight && !m_cue.cut && clothesOf(m_cue, place) < m_settings.clothes)
                return giveUp(robot_says::HeatBare, place);
            if (surface && (std::abs(error) < 1.2 * m_settings.tolerance || m_corrections >= 4))
                return reach(*surface, baseInOdom);
            ++m_corrections;
            m_phase = Phase::Approach;
            break;
    }
    return step;
}

}  // namespace leitstand
