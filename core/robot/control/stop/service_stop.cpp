#include "core/robot/control/stop/service_stop.h"

#include <utility>

namespace leitstand {

ServiceStop::ServiceStop(ServiceDescription service, const ServiceStopTiming& timing)
    : m_service(std::move(service)),
      m_timing(timing),
      m_stop(stopRequest(m_service)),
      m_release(releaseRequest(m_service)) {}

void ServiceStop::enter(Stage stage, SteadyTime now) {
    m_stage = stage;
    m_since = m_next = now;
    m_older = m_tag;
}

void ServiceStop::stop(SteadyTime now) {
    if (!m_stop && !m_release) return;
    m_refused = m_revoked = false;
    m_message.clear();
    m_refusal.clear();
    enter(m_stop ? Stage::Asked : Stage::Stopped, now);
}

void ServiceStop::release(SteadyTime now) {
    if (m_stage != Stage::Asked && m_stage != Stage::Stopped) return;
    m_refused = m_revoked = false;
    m_message.clear();
    m_refusal.clear();
    enter(m_release && m_offered ? Stage::Releasing : Stage::Idle, now);
}

void ServiceStop::revoke(std::string why, SteadyTime now) {
    m_revoked = true;
    m_refusal = std::move(why);
    enter(m_stop ? Stage::Asked : Stage::Stopped, now);
}

void ServiceStop::offered(bool offered, bool anew, SteadyTime now) {
    m_offered = offered;
    if (anew && m_stage == Stage::Stopped && m_stop) enter(Stage::Asked, now);
}

std::optional<ServiceStop::Call> ServiceStop::due(SteadyTime now) {
    if (m_stage == Stage::Releasing && now - m_since >= m_timing.release)
        revoke(title() + " did not answer the release: stopped again", now);
    const bool asking = m_stage == Stage::Asked || m_stage == Stage::Releasing;
    if (!asking || !m_offered || now < m_next) return std::nullopt;
    m_next = now + (m_refused ? m_timing.refused : m_timing.repeat);
    return Call{++m_tag, m_stage == Stage::Asked ? *m_stop : *m_release};
}

void ServiceStop::answered(std::uint64_t tag, const ServiceAnswer& answer, SteadyTime now) {
    const bool asking = m_stage == Stage::Asked || m_stage == Stage::Releasing;
    if (!asking || tag <= m_older) return;
    const bool releasing = m_stage == Stage::Releasing;
    m_refused = !answer.accepted;
    m_message = answer.accepted ? std::string() : answer.message;
    if (answer.accepted) {
        enter(releasing ? Stage::Idle : Stage::Stopped, now);
    } else if (releasing) {
        revoke(title() + (answer.message.empty() ? " refuses" : " refuses: " + answer.message), now);
    } else {
        m_next = now + m_timing.refused;
    }
}

bool ServiceStop::takeRevoked() {
    return std::exchange(m_revoked, false);
}

const std::string& ServiceStop::title() const {
    return m_service.title.empty() ? m_service.name : m_service.title;
}

StopServiceStatus ServiceStop::status() const {
    return {title(), m_stage, m_offered, m_refused, m_message};
}

}  // namespace leitstand
