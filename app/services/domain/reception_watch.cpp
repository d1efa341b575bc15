#include "app/services/domain/reception_watch.h"

#include <condition_variable>
#include <utility>

#include <pthread.h>

#include "core/base/words.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Rhythm(250);
/// After a rejoin all is announced again. A fault stands meanwhile, and ends when the robot is received or
/// gone.
constexpr std::chrono::seconds Gone(10);

std::string textOf(const Guid& guid) {
    return {guid.bytes.begin(), guid.bytes.end()};
}

Announced announcedIn(const DomainReception& domain) {
    Announced announced;
    for (const OfferedWriter& one : domain.writers)
        announced.writers.push_back({one.topic, textOf(one.participant), one.seconds, one.received});
    for (const DomainReception::Process& one : domain.mute) {
        if (!one.participant.refused) announced.mute.push_back({one.participant.name, one.seconds});
    }
    return announced;
}

/// Advice for when joining again does not help.
std::string adviceOn(ReceptionFault::Kind kind) {
    if (kind == ReceptionFault::Kind::Partial)
        return translate("leitstand::Hearing", "{}: {}; is the sensor switched on?");
    return translate("leitstand::Hearing",
                     "{}: {}; joining again did not help: look at the robot's program, at firewalls, and at "
                     "which networks both are in");
}

}  // namespace

ReceptionWatch::ReceptionWatch(Node& node, ReceptionWatchSetup setup)
    : m_node(node), m_setup(std::move(setup)), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

ReceptionWatch::~ReceptionWatch() = default;

std::optional<ReceptionFault> ReceptionWatch::fault(const std::string& robot) const {
    const std::lock_guard lock(m_mutex);
    const auto found = m_faults.find(robot);
    return found == m_faults.end() ? std::nullopt : std::optional(found->second.fault);
}

void ReceptionWatch::notify(const std::string& words, const RobotDescription& robot,
                            const ReceptionFault& fault) {
    m_setup.notify(leitstand::fill(words, robot.title, worded(fault)));
}

void ReceptionWatch::look() {
    const Announced announced = announcedIn(m_node.reception());
    const SteadyTime now = std::chrono::steady_clock::now();
    bool due = false;
    for (const RobotDescription& robot : m_setup.robots) {
        const LinkState link = m_setup.link(robot.name);
        RejoinPlan& plan = m_plans[robot.name];
        if (isReceived(robot, announced)) plan.received();
        const auto fault = receptionFaultOf(robot, link, announced);
        if (plan.isDue(fault, m_setup.mayRejoin(), now)) {
            due = true;
            notify(translate("leitstand::Hearing", "{}: {}; joining the network again"), robot, *fault);
        } else if (plan.hasFailed(fault, now)) {
            notify(adviceOn(fault->kind), robot, *fault);
        }
        const std::lock_guard lock(m_mutex);
        if (fault) m_faults[robot.name] = {*fault, now};
        const auto standing = m_faults.find(robot.name);
        if (standing != m_faults.end() && !fault &&
            (isOver(standing->second.fault, link, announced) || now - standing->second.newest > Gone))
            m_faults.erase(standing);
    }
    if (!due) return;
    if (const auto joined = m_node.rejoin(m_setup.onRejoining); !joined) m_setup.notify(joined.error().text);
}

void ReceptionWatch::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "hearing");
    std::mutex asleep;
    std::condition_variable_any never;
    while (!stop.stop_requested()) {
        look();
        std::unique_lock lock(asleep);
        never.wait_for(lock, stop, Rhythm, [] { return false; });
    }
}

}  // namespace leitstand
