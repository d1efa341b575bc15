#include "core/robot/control/drive_schedule.h"

namespace leitstand {

DriveSchedule::DriveSchedule(const DriveRhythm& rhythm) : m_rhythm(rhythm) {}

DriveSchedule::Decision DriveSchedule::decide(const DriveVelocity& velocity, bool driving, SteadyTime now) {
    const bool active = driving || !isZero(velocity);
    if (active) m_zerosLeft = m_rhythm.zeros;
    if (m_zerosLeft == 0) return {false, now + m_rhythm.period, false};

    const bool changed = velocity != m_last;
    // A stop is sent at once.
    const bool changeDue = changed && (isZero(velocity) || now >= m_sent + m_rhythm.shortest);
    if (!changeDue && now < m_due) {
        return {false, changed ? std::min(m_due, m_sent + m_rhythm.shortest) : m_due, true};
    }
    if (!active) --m_zerosLeft;
    m_last = velocity;
    m_sent = now;
    // Keeps in step while punctual: a caller that wakes up 2 ms late each time still sends 40 a second.
    m_due = !changeDue && now < m_due + m_rhythm.period ? m_due + m_rhythm.period : now + m_rhythm.period;
    return {true, m_due, m_zerosLeft > 0};
}

}  // namespace leitstand
