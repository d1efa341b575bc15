#include "robots/control/driving/victim_approach.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "core/base/time.h"
#include "core/robot/robot_format.h"

namespace leitstand {
namespace {

constexpr double InSight = 0.5;       // younger cues show the heat now [s]
constexpr double PassedRange = 2.5;   // the place of heat farther away is uncertain [m]
constexpr double UnknownRange = 2.0;  // assumed for heat without a surface [m]

/// Formats a length as robots report it.
std::string metres(double length) {
    return fmt::format("{:.2f}", length);
}

ExplorerSettings detourSettings(const VictimApproachSettings& settings) {
    ExplorerSettings detour;
    detour.lookFirst = 0.0;
    detour.goalNear = settings.distance + 0.2;
    return detour;
}

}  // namespace

VictimApproach::VictimApproach(FuzzyDrive drive, const VictimApproachSettings& settings)
    : m_drive(std::move(drive)), m_settings(settings), m_around(m_drive, detourSettings(settings)) {}

void VictimApproach::start(const HeatCue& cue, Time now) {
    m_phase = Phase::Turn;
    m_started = m_since = m_movedAt = now;
    m_stuck = false;
    m_cue = cue;
    m_cueAt = now;
    m_heat = placeOf(cue, UnknownRange);
    m_corrections = 0;
    m_place.reset();
    m_begun.reset();
    m_detour = false;
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

void VictimApproach::take(const HeatCue& cue) {
    if (cue.at <= m_cue.at || !cue.ray.direction.allFinite()) return;
    // Another body does not draw it away from its target.
    const double off =
        std::acos(std::clamp(cue.ray.direction.normalized().dot(m_cue.ray.direction), -1.0, 1.0));
    if (off > 0.6) return;
    m_cue = cue;
}

bool VictimApproach::Left::isAt(const Eigen::Vector2d& where) const {
    return std::min((place - where).norm(), (begun - where).norm()) < radius;
}

std::optional<HeatTarget> VictimApproach::target(const HeatCue& cue, const VirtualScanView& view,
                                                 const Pose& baseInOdom) const {
    return heatTarget(cue, view, baseInOdom, m_drive.settings().safety.body);
}

bool VictimApproach::isNew(const HeatCue& cue, const VirtualScanView& view, const Pose& baseInOdom) const {
    const auto surface = target(cue, view, baseInOdom);
    if (!surface || !surface->certain) return false;
    const Eigen::Vector2d place = flat(baseInOdom) * surface->inBase;
    if (heightAt(cue, place, baseInOdom) > m_settings.highest) return false;
    const auto there = [&](const Left& other) { return other.isAt(place); };
    if (isKnown(place) || std::any_of(m_givenUp.begin(), m_givenUp.end(), there)) return false;
    const auto glimpses = std::count_if(m_hidden.begin(), m_hidden.end(), there);
    return glimpses == 0 ||
           (glimpses < m_settings.tries && cue.size * surface->heat > 2.0 * m_settings.glimpse);
}

std::optional<Eigen::Vector3d> VictimApproach::another(const HeatCue& cue, const VirtualScanView& view,
                                                       const Pose& baseInOdom) const {
    if (!isActive() || !m_place) return std::nullopt;
    const auto surface = target(cue, view, baseInOdom);
    if (!surface || surface->heat > PassedRange) return std::nullopt;
    const Eigen::Vector3d heat = placeOf(cue, surface->heat);
    const double off = std::min((heat.head<2>() - *m_place).norm(), (heat - m_heat).head<2>().norm());
    Seen seen;
    seen.add(cue);
    if (off < m_settings.sameVictim || isBare(seen, surface->heat) || !isNew(cue, view, baseInOdom))
        return std::nullopt;
    return heat;
}

void VictimApproach::Seen::add(const HeatCue& cue) {
    skin = std::max(skin, cue.size);
    clothes = std::max(clothes, cue.clothes);
    skinCut = skinCut || cue.cut;
    clothesCut = clothesCut || cue.clothesCut;
}

bool VictimApproach::isHidden(const Seen& seen, double away) const {
    return !seen.skinCut && seen.skin * away < m_settings.glimpse;
}

bool VictimApproach::isBare(const Seen& seen, double away) const {
    const bool whole = !seen.skinCut || seen.skin * away > m_settings.bare;
    return whole && !seen.clothesCut && seen.clothes * away * away < m_settings.clothes;
}

bool VictimApproach::isKnown(const Eigen::Vector2d& place) const {
    return std::any_of(m_sightings.begin(), m_sightings.end(), [&](const Sighting& one) {
        return (one.position.head<2>() - place).norm() < m_settings.sameVictim;
    });
}

VictimApproach::Left VictimApproach::leftAt(const Eigen::Vector2d& place, double radius) const {
    return {place, m_begun.value_or(place), radius};
}

ApproachStep VictimApproach::giveUp(const std::string& reason, const Eigen::Vector2d& place, double radius) {
    m_givenUp.push_back(leftAt(place, radius));
    return leave(reason);
}

ApproachStep VictimApproach::leave(const std::string& reason) {
    m_phase = Phase::Idle;
    ApproachStep step;
    step.failed = true;
    step.reason = reason;
    return step;
}

bool VictimApproach::isStuck(const Pose& baseInOdom, Time now) {
    const Eigen::Isometry2d here = flat(baseInOdom), moved = m_moved.inverse() * here;
    const double turned = Eigen::Rotation2Dd(moved.linear()).angle();
    if (moved.translation().norm() > 0.03 || std::abs(turned) > 0.05) {
        m_moved = here;
        m_movedAt = now;
    }
    return secondsBetween(m_movedAt, now) > m_settings.stuckAfter;
}

ApproachStep VictimApproach::settled(const HeatTarget& target, const Pose& baseInOdom) {
    const Eigen::Vector2d place = flat(baseInOdom) * target.inBase;
    if (isKnown(place)) return giveUp(robot_format::VictimKnown, place, m_settings.sameVictim);
    if (isHidden(m_seen, target.heat)) {
        m_hidden.push_back(leftAt(place, m_settings.sameVictim));
        return leave(robot_format::HeatHidden);
    }
    if (isBare(m_seen, target.heat)) return giveUp(robot_format::HeatBare, place, m_settings.sameLamp);
    const bool right = std::abs(target.distance - m_settings.distance) < 1.2 * m_settings.tolerance;
    return right || m_stuck || m_corrections >= 4 ? reach(target, baseInOdom) : ApproachStep{};
}

ApproachStep VictimApproach::reach(const HeatTarget& target, const Pose& baseInOdom) {
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
    sighting.text = fmt::format(robot_format::BodyHeat, fmt::format("{:.1f}", m_cue.temperature));
    m_sightings.push_back(sighting);
    ApproachStep step;
    step.done = true;
    step.distance = target.distance;
    step.reason = fmt::format(robot_format::BeforeAVictim, metres(target.distance));
    return step;
}

bool VictimApproach::isBehindSomething(const std::optional<HeatTarget>& target, double bearing,
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
    if (!m_around.goal() || m_around.goal()->head<2>() != place)
        m_around.setGoal(Eigen::Vector3d(place.x(), place.y(), baseInOdom.translation().z()));
    const ExplorerStep around =
        m_around.step(view, baseInOdom, now - std::chrono::nanoseconds(std::llround(age * 1e9)), now);
    ApproachStep step;
    step.velocity = around.velocity;
    step.reason = robot_format::DrivesAround;
    return step;
}

DriveVelocity VictimApproach::towards(const std::optional<HeatTarget>& target, double bearing,
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
    reason =
        target ? fmt::format(robot_format::HeatAhead, metres(target->distance)) : robot_format::DrivesToHeat;
    if (!safe.reason.empty()) reason += "; " + safe.reason;
    return safe.velocity;
}

ApproachStep VictimApproach::step(const std::optional<HeatCue>& cue, const VirtualScanView& view,
                                  const Pose& baseInOdom, Time now) {
    ApproachStep step;
    if (m_phase == Phase::Idle) {
        step.failed = true;
        step.reason = robot_format::NoHeat;
        return step;
    }
    const Time before = m_cue.at;
    if (cue && cue->at > m_cue.at) take(*cue);
    if (m_cue.at > before) m_cueAt = now;
    m_around.see(view, baseInOdom, now);
    const bool inSight = secondsBetween(m_cueAt, now) < InSight;
    const auto surface = target(m_cue, view, baseInOdom);
    m_heat = placeOf(m_cue, surface ? surface->heat : UnknownRange);
    if (surface && inSight) m_place = flat(baseInOdom) * surface->inBase;
    if (surface && !m_begun) m_begun = flat(baseInOdom) * surface->inBase;
    if (surface) step.distance = surface->distance;
    if (m_cue.at > before) m_seen.add(m_cue);
    if (m_phase == Phase::Reached) {
        step.done = true;
        step.reason = robot_format::AtAVictim;
        return step;
    }
    const double direction = bearingOf(m_cue, baseInOdom);
    const Eigen::Vector2d ahead =
        surface ? surface->inBase
                : Eigen::Vector2d(UnknownRange * std::cos(direction), UnknownRange * std::sin(direction));
    const Eigen::Vector2d place = flat(baseInOdom) * ahead;
    // Near the end a victim on the floor may be out of the camera's sight.
    const bool close = surface && surface->distance < m_settings.distance + 0.5;
    if (secondsBetween(m_cueAt, now) > m_settings.lostAfter * (close || m_detour ? 3.0 : 1.0))
        return giveUp(robot_format::HeatLost, place, m_settings.sameVictim);
    if (secondsBetween(m_started, now) > m_settings.giveUpAfter)
        return giveUp(robot_format::HeatUnreachable, place, m_settings.sameVictim);

    const double bearing = std::atan2(ahead.y(), ahead.x());
    const double error = surface ? surface->distance - m_settings.distance : 1.0;
    switch (m_phase) {
        case Phase::Idle:
        case Phase::Reached:
            break;
        case Phase::Turn:
            step.reason = robot_format::TurnsToHeat;
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
            m_stuck =
                isStuck(baseInOdom, now) && inSight && surface && surface->distance < m_settings.stuckWithin;
            if (m_stuck ||
                (surface && std::abs(error) < 0.3 * m_settings.tolerance && std::abs(bearing) < 0.3)) {
                m_phase = Phase::Settle;
                m_since = now;
                m_seen = {};
                step.reason = robot_format::MeasuresAgain;
                break;
            }
            // A target out of sight on a detour is still where it was.
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
            step.reason = robot_format::MeasuresAgain;
            // What was seen only on the way here may belong to something else.
            if (secondsBetween(m_since, now) < m_settings.settle || m_cueAt <= m_since) break;
            if (surface) {
                const ApproachStep end = settled(*surface, baseInOdom);
                if (end.done || end.failed) return end;
            }
            m_movedAt = now;  // it stood to measure
            ++m_corrections;
            m_phase = Phase::Approach;
            break;
    }
    return step;
}

}  // namespace leitstand
