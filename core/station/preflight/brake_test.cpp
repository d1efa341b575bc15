#include "core/station/preflight/brake_test.h"

#include <cmath>

#include "core/base/time.h"

namespace leitstand {
namespace {

using Cause = BrakeResult::Cause;
using Watchdog = BrakeResult::Watchdog;

constexpr double Braking = 0.8;  ///< share of its speed at the cut below which it brakes

}  // namespace

void BrakeTest::enter(Phase phase, SteadyTime now) {
    m_phase = phase;
    m_since = now;
}

void BrakeTest::start(SteadyTime now) {
    m_result = {};
    m_released.reset();
    m_moving.reset();
    m_cut.reset();
    m_newest.reset();
    m_held = now;
    enter(Phase::Neutral, now);
}

void BrakeTest::odometry(Time stamp, const Eigen::Vector2d& position, double speed, double turn) {
    if (m_newest && stamp <= m_newest->stamp) return;
    m_newest = Motion{stamp, position, speed, turn};
    if (m_cut && std::abs(speed) > Braking * std::abs(m_cut->speed)) m_atSpeed = stamp;
}

bool BrakeTest::isStanding() const {
    return m_newest && std::abs(m_newest->speed) < m_settings.standing &&
           std::abs(m_newest->turn) < 10.0 * m_settings.standing;
}

void BrakeTest::finish(BrakeResult::Verdict verdict, Watchdog watchdog, double duration, double way) {
    m_result = {.verdict = verdict, .seconds = duration, .metres = way, .watchdog = watchdog};
    if (watchdog == Watchdog::Stops) m_result.brakesAfter = toSeconds(m_atSpeed - m_cut->stamp);
    m_phase = Phase::Done;
}

void BrakeTest::end(BrakeResult::Cause cause) {
    if (!isRunning()) return;
    m_result = {.verdict = BrakeResult::Verdict::Inconclusive, .cause = cause};
    m_phase = Phase::Done;
}

BrakeTest::Step BrakeTest::step(const BrakeFacts& facts, SteadyTime now) {
    if (!isRunning()) return {};
    // After the cut the robot is on its own: releasing the key means nothing against it.
    if (m_phase != Phase::Cut && toSeconds(now - m_held) > m_settings.hold) {
        end(Cause::KeyLetGo);
    } else if (m_phase != Phase::Neutral && !facts.mayDrive) {
        end(Cause::NotDriven);
    }
    switch (m_phase) {
        case Phase::Neutral:
            return neutral(facts, now);
        case Phase::Driving:
            return drive(now);
        case Phase::Cut:
            return watch(now);
        case Phase::Idle:
        case Phase::Done:
            break;
    }
    return {};
}

BrakeTest::Step BrakeTest::neutral(const BrakeFacts& facts, SteadyTime now) {
    const bool ready = facts.mayDrive && facts.listening && !facts.needsNeutral && isStanding();
    if (!ready) m_released.reset();
    if (ready && !m_released) m_released = now;
    if (m_released && toSeconds(now - *m_released) >= m_settings.neutral) {
        if (std::isnan(facts.spaceAhead)) {
            end(Cause::RoomUnknown);
        } else if (facts.spaceAhead < m_settings.space) {
            end(Cause::NoRoom);
            m_result.free = facts.spaceAhead;
            m_result.needed = m_settings.space;
        } else {
            enter(Phase::Driving, now);
            return {{m_settings.speed, 0.0, 0.0}, false};
        }
    } else if (toSeconds(now - m_since) > m_settings.start) {
        end(!facts.mayDrive      ? Cause::NotAllowed
            : !facts.listening   ? Cause::Deaf
            : !m_newest          ? Cause::NoOdometry
            : facts.needsNeutral ? Cause::SticksHeld
                                 : Cause::NotStanding);
    }
    return {};
}

BrakeTest::Step BrakeTest::drive(SteadyTime now) {
    const Step driving{{m_settings.speed, 0.0, 0.0}, false};
    const bool atSpeed = m_newest && m_newest->speed > 0.5 * m_settings.speed;
    if (atSpeed && !m_moving) m_moving = now;
    if (m_moving && toSeconds(now - *m_moving) >= m_settings.run) {
        m_cut = m_newest;
        m_atSpeed = m_cut->stamp;
        enter(Phase::Cut, now);
        return {{}, true};
    }
    if (toSeconds(now - m_since) <= m_settings.drive) return driving;
    end(Cause::TooSlow);
    return {};
}

BrakeTest::Step BrakeTest::watch(SteadyTime now) {
    // Between two of the robot's own stamps, however late they arrive over the link.
    const double duration = toSeconds(m_newest->stamp - m_cut->stamp);
    const double way = (m_newest->position - m_cut->position).norm();
    if (duration > 0.0 && isStanding()) {
        const bool good = duration <= m_settings.stopTime && way <= m_settings.stopDistance;
        finish(good ? BrakeResult::Verdict::Passed : BrakeResult::Verdict::Failed, Watchdog::Stops, duration,
               way);
        return {};
    }
    if (duration > m_settings.giveUp) {
        finish(BrakeResult::Verdict::Failed, Watchdog::None, duration, way);
        return {};
    }
    if (toSeconds(now - m_since) > 2.0 * m_settings.giveUp) {
        end(Cause::OdometryEnded);
        return {};
    }
    // What goes on too long or too far is stopped by zeros at once, and has failed.
    if (way > 3.0 * m_settings.stopDistance) {
        finish(BrakeResult::Verdict::Failed, Watchdog::None, duration, way);
        return {};
    }
    return {{}, true};
}

}  // namespace leitstand
