#include "core/robot/control/grant_arbiter.h"

#include <algorithm>
#include <utility>

#include "core/event/station_samples.h"

namespace leitstand {
namespace {

using Action = GrantSample::Action;

constexpr std::size_t MostSuperseded = 32;

}  // namespace

GrantArbiter::GrantArbiter(GrantId id, const GrantTiming& timing) : m_id(std::move(id)), m_timing(timing) {}

bool GrantArbiter::isSilent(const Holder& holder, SteadyTime now) const {
    return now - holder.received >= m_timing.silence;
}

bool GrantArbiter::mayTake(const std::string& station, const Sender& from, SteadyTime now) const {
    if (!m_holder) {
        return m_reservedFor.empty() || m_reservedFor == station || now - m_reserved >= m_timing.silence;
    }
    if (isSilent(*m_holder, now)) return true;
    return m_holder->station == station &&
           std::find(m_superseded.begin(), m_superseded.end(), from) == m_superseded.end();
}

void GrantArbiter::take(Holder next) {
    if (m_holder && m_holder->station == next.station) {
        m_superseded.push_back(m_holder->sender);
        if (m_superseded.size() > MostSuperseded) m_superseded.pop_front();
    } else {
        m_superseded.clear();
    }
    std::erase(m_superseded, next.sender);
    m_holder = std::move(next);
    m_other.reset();
    m_reservedFor.clear();
    ++m_changes;
}

void GrantArbiter::receive(const GrantSample& sample, const Sender& from, SteadyTime now) {
    if (sample.kind != m_id.kind || sample.robot != m_id.robot || sample.station.empty()) return;
    const bool fromHolder = m_holder && m_holder->sender == from && m_holder->station == sample.station;
    switch (sample.action) {
        case Action::Hold:
            if (fromHolder) {
                m_holder->received = now;
            } else if (mayTake(sample.station, from, now)) {
                take({sample.station, from, now});
            } else {
                m_other = Holder{sample.station, from, now};
            }
            return;
        case Action::Consent:
        case Action::Release:
            if (m_other && m_other->sender == from) m_other.reset();
            if (!fromHolder) return;
            m_holder.reset();
            m_superseded.clear();
            ++m_changes;
            m_reservedFor = sample.action == Action::Consent ? sample.other : std::string();
            m_reserved = now;
            // Its heartbeat may have arrived before the consent.
            if (m_other && m_other->station == m_reservedFor && !isSilent(*m_other, now)) take(*m_other);
            return;
        case Action::Request:
        case Action::Refuse:
            return;
    }
}

bool GrantArbiter::obeys(const Sender& from, SteadyTime now) const {
    return m_holder && m_holder->sender == from && !isSilent(*m_holder, now);
}

std::string GrantArbiter::holder(SteadyTime now) const {
    return m_holder && !isSilent(*m_holder, now) ? m_holder->station : std::string();
}

}  // namespace leitstand
