#include "robots/control/driving/evasion.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/time.h"
#include "core/robot/robot_format.h"

namespace leitstand {
namespace {

bool isBackwards(const DriveVelocity& wanted) {
    constexpr double Least = 0.02;  // rules for turns on the spot leave a little forward speed [m/s]
    return wanted.forward < -Least;
}

/// Returns the way (-1 backwards, 1 forwards) away from what was met at @p side, for a robot that wanted to
/// drive @p wanted.
int wayOff(BodySide side, const DriveVelocity& wanted) {
    if (side == BodySide::Front) return -1;
    if (side == BodySide::Rear) return 1;
    return isBackwards(wanted) ? 1 : -1;
}

}  // namespace

void Evasion::reset() {
    m_bump.reset();
    m_ended.reset();
    m_back = m_last = m_times = 0;
}

double Evasion::caution() const {
    if (m_lean <= m_settings.slowFrom) return 1.0;
    const double over =
        std::min(1.0, (m_lean - m_settings.slowFrom) / (m_settings.backFrom - m_settings.slowFrom));
    return 1.0 - over * (1.0 - m_settings.slowest);
}

void Evasion::begin(int back, const Pose& baseInOdom, Time now, const std::string& reason) {
    const bool again = m_ended && secondsBetween(*m_ended, now) < m_settings.apart;
    m_times = again || m_back != 0 ? m_times + 1 : 1;
    m_back = m_last = back;
    m_from = baseInOdom.translation().head<2>();
    m_since = now;
    m_reason = reason;
}

EvasionStep Evasion::step(const DriveVelocity& wanted, const Pose& baseInOdom, Time now) {
    EvasionStep step;
    const auto bump = std::exchange(m_bump, std::nullopt);
    if (bump) {
        const int off = wayOff(*bump, wanted);
        // It need not leave again what it is already leaving.
        if (m_back == 0 || off != m_back) {
            step.felt = *bump;
            step.touched = true;
            begin(off, baseInOdom, now, robot_format::BacksOut);
        }
    } else if (m_back == 0 && m_lean >= m_settings.backFrom) {
        // When backing out led to leaning again, it goes the other way.
        const bool again = m_ended && secondsBetween(*m_ended, now) < m_settings.apart;
        const int off = again ? -m_last : isBackwards(wanted) ? 1 : -1;
        step.felt = off < 0 ? BodySide::Front : BodySide::Rear;
        begin(off, baseInOdom, now, robot_format::LeansBacksOut);
    }
    if (m_times > m_settings.most) {
        step.failed = true;
        step.reason = robot_format::NoWayOff;
        reset();
        return step;
    }
    if (m_back == 0) return step;
    const double way = (baseInOdom.translation().head<2>() - m_from).norm();
    if (way >= m_settings.way || secondsBetween(m_since, now) > m_settings.within) {
        m_back = 0;
        m_ended = now;
        return step;
    }
    step.velocity = DriveVelocity{m_back * m_settings.speed, 0.0, 0.0};
    step.reason = m_reason;
    return step;
}

}  // namespace leitstand
