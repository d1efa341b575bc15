#include "robots/control/driving/explorer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/base/rotation/heading.h"
#include "core/base/time.h"
#include "core/robot/robot_format.h"

namespace leitstand {
namespace {

constexpr double Pi = std::numbers::pi;
constexpr int EmptyPlans = 6;      // so many plans without a way mean that there is none
constexpr int MostRecoveries = 2;  // at one place, before the aim is given up
constexpr int MostDoubts = 2;      // without new floor in between
constexpr double NewFloor = 4.0;   // [m2]
constexpr double Progress = 0.15;  // [m]

Time after(Time from, double seconds) {
    return from + std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

double lengthOf(const std::vector<Eigen::Vector3d>& way) {
    double length = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
    return length;
}

}  // namespace

Explorer::Explorer(FuzzyDrive drive, const ExplorerSettings& settings)
    : m_drive(std::move(drive)), m_settings(settings), m_memory(settings.memory) {}

void Explorer::setGoal(const std::optional<Eigen::Vector3d>& goal) {
    if (m_goal == goal) return;
    m_goal = goal;
    m_way.clear();
    m_planned.reset();
    m_emptyPlans = 0;
}

void Explorer::resume() {
    m_way.clear();
    m_planned.reset();
    m_progressAt.reset();
    m_recoverUntil.reset();
    m_recoveries = 0;
    m_emptyPlans = 0;
}

void Explorer::see(const VirtualScanView& view, const Pose& baseInOdom, Time now) {
    m_memory.see(view, baseInOdom);
    if (!m_seen) m_seen = now;
}

void Explorer::plan(const Pose& baseInOdom, Time now) {
    if (m_planned && secondsBetween(*m_planned, now) < m_settings.replan && now >= *m_planned) return;
    m_planned = now;
    const Eigen::Vector3d here = baseInOdom.translation();
    if (m_goal) {
        m_way = m_memory.wayTo(here, *m_goal, m_settings.goalNear);
    } else {
        // Keeps its aim while there is something to see there: it does not waver between two.
        bool keep = !m_way.empty() && (m_way.back() - here).head<2>().norm() > m_settings.arrived &&
                    m_memory.isBorderNear(m_way.back());
        // Some ways seem free only from afar, and other ways only from there.
        if (keep && now > m_patience) {
            m_memory.giveUp(m_way.back(), 0.5);
            keep = false;
        }
        if (keep) m_way = m_memory.wayTo(here, m_way.back());
        if (!keep || m_way.empty()) {
            m_way = m_memory.wayToUnseen(here, {headingOf(baseInOdom), m_settings.turnCost});
            m_patience =
                after(now, m_settings.patience + lengthOf(m_way) / (0.25 * m_drive.settings().speed));
        }
    }
    m_emptyPlans = m_way.empty() ? m_emptyPlans + 1 : 0;
}

bool Explorer::looksAgain(const Pose& baseInOdom, Time now) {
    // Whoever stood in the way may have moved on meanwhile.
    if (m_doubted && m_doubts <= MostDoubts && secondsBetween(*m_doubted, now) >= m_settings.waitForOthers)
        m_doubted.reset();
    if (!m_doubted) {
        const double seen = m_memory.seenArea();
        m_doubts = seen > m_seenThen + NewFloor ? 1 : m_doubts + 1;
        m_seenThen = seen;
        m_doubted = now;
        if (m_doubts <= MostDoubts) m_memory.doubt(baseInOdom.translation(), 1.5);
    }
    return m_doubts <= MostDoubts;
}

std::optional<Eigen::Vector2d> Explorer::aim(const Pose& baseInOdom) const {
    if (m_way.empty()) return std::nullopt;
    const Eigen::Vector3d here = baseInOdom.translation();
    Eigen::Vector3d aim = m_way.front();
    double length = (aim - here).norm();
    for (std::size_t i = 1; i < m_way.size(); ++i) {
        length += (m_way[i] - m_way[i - 1]).norm();
        if (length > m_settings.aimAhead || !m_memory.isFreeBetween(here, m_way[i])) break;
        aim = m_way[i];
    }
    return aim.head<2>();
}

std::optional<DriveVelocity> Explorer::recover(const VirtualScanView& view, const Pose& baseInOdom, Time now,
                                               bool wantsToMove) {
    const auto& safety = m_drive.settings().safety;
    if (m_recoverUntil && now < *m_recoverUntil) {
        return safeVelocity(m_recovery, view, safety).velocity;
    }
    m_recoverUntil.reset();
    const Eigen::Vector2d here = baseInOdom.translation().head<2>();
    if (!wantsToMove || !m_progressAt || (here - m_progress).norm() > Progress) {
        if (m_progressAt && (here - m_progress).norm() > 3.0 * Progress) m_recoveries = 0;
        if (m_progressAt && (here - m_progress).norm() > Progress) m_doubted.reset();
        m_progress = here;
        m_progressAt = now;
        return std::nullopt;
    }
    if (secondsBetween(*m_progressAt, now) < m_settings.stuckAfter) return std::nullopt;
    if (++m_recoveries > MostRecoveries && !m_way.empty()) {
        if (!m_goal) m_memory.giveUp(m_way.back(), 0.5);
        m_way.clear();
        m_planned.reset();
        m_recoveries = 0;
    }
    // Picks the motion with most space, backwards first.
    double best = -1.0;
    const double slow = 0.5 * m_drive.settings().speed, turn = 0.6 * m_drive.settings().turnRate;
    for (const DriveVelocity& one : {DriveVelocity{-slow, 0.0, 0.0}, DriveVelocity{-slow, 0.0, 0.4 * turn},
                                     DriveVelocity{-slow, 0.0, -0.4 * turn}, DriveVelocity{0.0, 0.0, turn},
                                     DriveVelocity{0.0, 0.0, -turn}, DriveVelocity{slow, 0.0, 0.0}}) {
        const double free = view.freeTravel(one.forward, one.turn, safety.body.grown(safety.margin), 0.6);
        if (free <= best + 0.05) continue;
        best = free;
        m_recovery = one;
    }
    m_progressAt = now;
    m_recoverUntil = after(now, m_settings.recoverFor);
    return safeVelocity(m_recovery, view, safety).velocity;
}

ExplorerStep Explorer::step(const VirtualScanView& view, const Pose& baseInOdom,
                            const std::optional<Time>& newest, Time now) {
    ExplorerStep step;
    see(view, baseInOdom, now);
    if (!newest || secondsBetween(*newest, now) > m_settings.blindAfter) {
        step.reason = robot_format::ScannerSilent;
        return step;
    }
    if (secondsBetween(*m_seen, now) < m_settings.lookFirst) {
        step.reason = robot_format::LooksAround;
        return step;
    }
    const Eigen::Vector2d here = baseInOdom.translation().head<2>();
    const auto isAt = [&](const Eigen::Vector3d& place) {
        return (place.head<2>() - here).norm() < m_settings.arrived &&
               FloorMemory::isSameFloor(place.z(), baseInOdom.translation().z());
    };
    if (m_goal && (isAt(*m_goal) || (!m_way.empty() && isAt(m_way.back())))) {
        step.done = true;
        step.reason = robot_format::AtTheGoal;
        return step;
    }
    plan(baseInOdom, now);
    step.way = m_way;
    if (m_emptyPlans >= EmptyPlans && looksAgain(baseInOdom, now)) {
        step.reason = robot_format::LooksAgain;
        return step;
    }
    if (m_emptyPlans >= EmptyPlans) {
        step.done = !m_goal;
        step.failed = m_goal.has_value();
        step.reason = m_goal ? robot_format::NoWayToTheGoal : robot_format::NothingLeft;
        return step;
    }
    const auto towards = aim(baseInOdom);
    if (const auto recovery = recover(view, baseInOdom, now, towards.has_value())) {
        step.velocity = *recovery;
        step.reason = robot_format::MakesRoom;
        return step;
    }
    if (!towards) {
        step.reason = robot_format::LooksForAWay;
        return step;
    }
    const Eigen::Vector2d off = *towards - here;
    const double bearing = std::remainder(std::atan2(off.y(), off.x()) - headingOf(baseInOdom), 2.0 * Pi);
    const FuzzyDriveStep driven = m_drive.step(view, bearing);
    step.velocity = driven.velocity;
    step.reason = driven.reason;
    return step;
}

}  // namespace leitstand
